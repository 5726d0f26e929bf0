#include "rigid/attitude_of_a_free_body.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

double geometric_phase(const Vector3d& I, const Vector3d& omega0) {
  const Vector3d squares = omega0.cwiseAbs2();
  const double L = I.cwiseProduct(omega0).norm();
  const double above_first = I[1] * (I[1] - I[0]) * squares[1] + I[2] * (I[2] - I[0]) * squares[2];  // L² − 2T I₁
  const double below_third = I[0] * (I[2] - I[0]) * squares[0] + I[1] * (I[2] - I[1]) * squares[1];  // 2T I₃ − L²
  const double round_3 = above_first * (I[2] - I[1]), round_1 = below_third * (I[1] - I[0]);
  const double rate = std::sqrt(std::max(round_3, round_1) / I.prod());
  const double k = std::sqrt(std::min(round_3, round_1) / std::max(round_3, round_1));
  if (std::isnan(k)) return k;  // no such body; the series of the integral would not converge
  const double minus_cot2 = -I[2] * above_first / (I[0] * below_third);
  const double n = round_3 > round_1 ? k * k * minus_cot2 : minus_cot2;

  // What the turn of axis 3 about L in a period has more than 2T P/L.
  const double more = 4 / rate *
                      (L * (I[2] - I[0]) / (I[0] * I[2]) * boost::math::ellint_3(k, n) -
                       below_third / (L * I[2]) * boost::math::ellint_1(k));
  // Round axis 3, ψ goes through a whole turn in the other sense, which the body does not see.
  return round_3 > round_1 ? 2 * std::numbers::pi - more : more;
}

}  // namespace rigid
