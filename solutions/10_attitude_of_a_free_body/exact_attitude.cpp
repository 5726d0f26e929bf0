#include "rigid/attitude_of_a_free_body.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <cmath>
#include <numbers>

namespace rigid {

Matrix3d exact_attitude(const Vector3d& I, const Vector3d& omega0, double t) {
  using boost::math::ellint_1, boost::math::ellint_3;
  constexpr double turn = 2 * std::numbers::pi;
  // The angular velocity as in exact_rotation, by its amplitude am u: sn u = sin am u, cn u = cos am u.
  const Vector3d squares = omega0.cwiseAbs2();
  const int c = I[2] * (I[2] - I[1]) * squares[2] > I[0] * (I[1] - I[0]) * squares[0] ? 2 : 0, a = 2 - c;
  const double Ia = I[a], Ib = I[1], Ic = I[c];
  const double above = Ib * (Ib - Ia) * squares[1] + Ic * (Ic - Ia) * squares[c];  // L² − 2T I_a
  const double below = Ia * (Ic - Ia) * squares[a] + Ib * (Ic - Ib) * squares[1];  // 2T I_c − L²
  const double rate = std::sqrt(above * (Ic - Ib) / I.prod());
  const double k = std::sqrt(below * (Ib - Ia) / (above * (Ic - Ib)));
  const double sense = std::copysign(1.0, omega0[c]);
  Vector3d largest;
  largest[a] = std::sqrt(below / (Ia * (Ic - Ia)));
  largest[1] = sense * std::sqrt(below / (Ib * (Ic - Ib)));
  largest[c] = sense * std::sqrt(above / (Ic * (Ic - Ia)));
  const double from = std::atan2(omega0[1] / largest[1], omega0[a] / largest[a]);
  const double u = rate * t + ellint_1(k, from);
  if (!std::isfinite(u)) return Matrix3d::Constant(u);  // no such motion; the library would not come to an end with NaN
  const double sn = boost::math::jacobi_sn(k, u), cn = boost::math::jacobi_cn(k, u);
  Vector3d omega;
  omega[a] = largest[a] * cn;
  omega[1] = largest[1] * sn;
  // dn u; the library's divides two cosines that vanish together at a quarter of the period.
  omega[c] = largest[c] * std::sqrt((1 - k) * (1 + k) + k * k * cn * cn);
  // am u stays within a right angle of πu/2K, which tells the whole turns that the arctangent has lost.
  const double within = std::atan2(sn, cn);
  const double to = within + turn * std::round(u / (4 * ellint_1(k)) - within / turn);

  // The angle of axis 3 about L: dφ/dt = L/I₃ + L(I₃ − I₁)/(I₁I₃)/(1 − n sn²).
  const Vector3d L0 = I.cwiseProduct(omega0);
  const double cotangent = I[2] * largest[2] / (I[0] * largest[0]);
  const double n = -cotangent * cotangent * (c == 2 ? k * k : 1);
  const double phi =
      L0.norm() / I[2] * (t + (I[2] - I[0]) / (I[0] * rate) * (ellint_3(k, n, to) - ellint_3(k, n, from)));

  // The attitude in a frame whose third axis is along L: z–y–z angles, of which L on the axes of the body tells two.
  const auto upright = [](double about_L, const Vector3d& L) {
    return Eigen::AngleAxisd(about_L, Vector3d::UnitZ()) *
           Eigen::AngleAxisd(std::atan2(L.head<2>().norm(), L[2]), Vector3d::UnitY()) *
           Eigen::AngleAxisd(std::atan2(L[1], -L[0]), Vector3d::UnitZ());
  };
  return (upright(0, L0).inverse() * upright(phi, I.cwiseProduct(omega))).toRotationMatrix();
}

}  // namespace rigid
