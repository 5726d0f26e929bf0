/// @file
/// The exact torque-free motion of a rigid body: a judge of integrators, itself free of them.
#pragma once

#include "solutions/judging/mechanics.hpp"

#include <Eigen/Dense>

namespace workbook::judging {

/// (L² − 2T I₂)/L² for ascending moments: positive for motion round axis 3, negative round axis 1.
inline double side_of_separatrix(const Vector3d& I, const Vector3d& w) {
  const double excess = I[2] * (I[2] - I[1]) * w[2] * w[2] - I[0] * (I[1] - I[0]) * w[0] * w[0];
  return excess / L_of(I, w).squaredNorm();
}

/// Formulas may hold for one of the two kinds of motion only.
template <class Exercise>
void either_side_of_separatrix(Exercise& e) {
  e.region("omega0 goes round the axis of the smallest moment (L² < 2TI₂)",
           [](auto& I, auto& w, auto...) { return side_of_separatrix(I, w) < 0; });
  e.region("omega0 goes round the axis of the largest moment (L² > 2TI₂)",
           [](auto& I, auto& w, auto...) { return side_of_separatrix(I, w) > 0; });
}

/// Torque-free rotation of a body with principal moments I, exact for every body and every start.
///
/// Order the axes as (a, b, c): b has the middle moment, and c is the extreme axis that the angular momentum circles:
/// c has the largest moment if \f$L^2 > 2 T I_b\f$ and the smallest if \f$L^2 < 2 T I_b\f$. Then
///
/// \f[ \omega_a = \alpha A\,\mathrm{cn}\,u, \qquad \omega_b = \beta B\,\mathrm{sn}\,u, \qquad
///     \omega_c = \gamma C\,\mathrm{dn}\,u, \qquad u = \lambda t + u_0 , \f]
/// \f[ \lambda^2 = C^2\,\frac{(I_c - I_a)(I_c - I_b)}{I_a I_b}, \qquad
///     1 - m = \frac{L^2 - 2 T I_b}{C^2\, I_c\, (I_c - I_b)} , \f]
///
/// with signs \f$\alpha, \gamma\f$ as at the start, and \f$\beta = \alpha\gamma\,\mathrm{sgn}(I_c - I_b)\f$ times the
/// parity of (a, b, c). The amplitudes are sums of squares, so that nothing cancels:
///
/// \f[ A^2 = \omega_a^2 + \frac{I_b (I_c - I_b)}{I_a (I_c - I_a)}\,\omega_b^2, \qquad
///     B^2 = \omega_b^2 + \frac{I_a (I_c - I_a)}{I_b (I_c - I_b)}\,\omega_a^2, \qquad
///     C^2 = \omega_c^2 + \frac{I_b (I_b - I_a)}{I_c (I_c - I_a)}\,\omega_b^2 . \f]
///
/// m = 0 is the symmetric top (cosine and sine), m = 1 the separatrix (hyperbolic functions). A start on a principal
/// axis, and every start of a sphere, is a steady rotation. Elliptic functions enter through 1 − m, the complementary
/// parameter: near the separatrix m itself has lost it.
class ExactTop {
 public:
  /// @param moments  principal moments in any order, positive, kg m²
  /// @param omega0   body components of ω at t = 0 on the same axes, rad/s
  ExactTop(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega0);

  /// Body components of ω, rad/s.
  Eigen::Vector3d omega(double t) const;

  /// Full period of ω in the body, s; infinite on the separatrix, and 0 for a steady rotation.
  double period() const;

  /// 1 − m, the complementary parameter of the elliptic functions; 1 for a steady rotation.
  double complementary_parameter() const { return complement_; }

  /// λ, the rate at which the argument of the elliptic functions grows, 1/s; 0 for a steady rotation.
  double rate() const { return rate_; }

 private:
  Eigen::Vector3d omega0_;
  bool steady_ = false;
  int a_ = 0, b_ = 1, c_ = 2;                            // the axes of cn, sn and dn
  Eigen::Vector3d amplitude_ = Eigen::Vector3d::Zero();  // αA, βB, γC in this order
  double rate_ = 0.0;                                    // λ
  double complement_ = 1.0;                              // 1 − m
  double start_ = 0.0;                                   // u₀
};

/// The exact answer to the exercise free_rotation, with its signature: one column of body components per time.
Eigen::Matrix3Xd exact_free_rotation(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega0,
                                     const Eigen::VectorXd& times);

/// Jacobi's amplitude am(u|m) from the complementary parameter 1 − m in [0, 1], for any real u; it grows with u
/// without jumps: sn u = sin am u, cn u = cos am u.
double jacobi_amplitude(double u, double complementary_parameter);

}  // namespace workbook::judging
