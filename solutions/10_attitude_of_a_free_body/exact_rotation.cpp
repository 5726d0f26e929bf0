#include "rigid/attitude_of_a_free_body.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <cmath>

namespace rigid {

Vector3d exact_rotation(const Vector3d& I, const Vector3d& omega0, double t) {
  // ω circles axis c, axis 3 if L² > 2T I₂ and else axis 1; a is the other one of the two.
  const Vector3d squares = omega0.cwiseAbs2();
  const int c = I[2] * (I[2] - I[1]) * squares[2] > I[0] * (I[1] - I[0]) * squares[0] ? 2 : 0, a = 2 - c;
  const double Ia = I[a], Ib = I[1], Ic = I[c];
  // L² − 2T I_a and 2T I_c − L² as sums over the two other axes, so that no two large numbers are subtracted. Round
  // axis 1 every bracket is negative; they come in pairs.
  const double above = Ib * (Ib - Ia) * squares[1] + Ic * (Ic - Ia) * squares[c];
  const double below = Ia * (Ic - Ia) * squares[a] + Ib * (Ic - Ib) * squares[1];
  const double rate = std::sqrt(above * (Ic - Ib) / I.prod());
  const double k = std::sqrt(below * (Ib - Ia) / (above * (Ic - Ib)));
  const double sense = std::copysign(1.0, omega0[c]);
  const double cn_part = std::sqrt(below / (Ia * (Ic - Ia)));
  const double sn_part = sense * std::sqrt(below / (Ib * (Ic - Ib)));
  const double dn_part = sense * std::sqrt(above / (Ic * (Ic - Ia)));

  const double u = rate * t + boost::math::ellint_1(k, std::atan2(omega0[1] / sn_part, omega0[a] / cn_part));
  if (!std::isfinite(u)) return Vector3d::Constant(u);  // no such motion; the library would not come to an end with NaN
  const double sn = boost::math::jacobi_sn(k, u), cn = boost::math::jacobi_cn(k, u);
  Vector3d omega;
  omega[a] = cn_part * cn;
  omega[1] = sn_part * sn;
  // dn u; the library's divides two cosines that vanish together at a quarter of the period.
  omega[c] = dn_part * std::sqrt((1 - k) * (1 + k) + k * k * cn * cn);
  return omega;
}

}  // namespace rigid
