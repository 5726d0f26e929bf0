#include "rigid/attitude_of_a_free_body.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>

#include <algorithm>
#include <cmath>

namespace rigid {

double turn_per_period(const Vector3d& I, const Vector3d& omega0) {
  const Vector3d squares = omega0.cwiseAbs2();
  const double L = I.cwiseProduct(omega0).norm();
  // L² − 2T I₁ and 2T I₃ − L² as sums over the two other axes, so that no two large numbers are subtracted.
  const double above_first = I[1] * (I[1] - I[0]) * squares[1] + I[2] * (I[2] - I[0]) * squares[2];
  const double below_third = I[0] * (I[2] - I[0]) * squares[0] + I[1] * (I[2] - I[1]) * squares[1];
  const double round_3 = above_first * (I[2] - I[1]), round_1 = below_third * (I[1] - I[0]);
  const double rate = std::sqrt(std::max(round_3, round_1) / I.prod());
  const double k = std::sqrt(std::min(round_3, round_1) / std::max(round_3, round_1));
  if (std::isnan(k)) return k;  // no such body; the series of the integral would not converge

  // dφ/dt = L/I₃ + (L/I₃)(2T I₃ − L²)/(I₁²ω₁² + I₂²ω₂²), and the denominator is I₁²a₁² (1 − n sn²).
  const double minus_cot2 = -I[2] * above_first / (I[0] * below_third);  // of the angle of axis 3 with L at ω₂ = 0
  const double n = round_3 > round_1 ? k * k * minus_cot2 : minus_cot2;
  return 4 * L / (I[2] * rate) * (boost::math::ellint_1(k) + (I[2] - I[0]) / I[0] * boost::math::ellint_3(k, n));
}

}  // namespace rigid
