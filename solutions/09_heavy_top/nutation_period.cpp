#include "rigid/heavy_top.hpp"

#include <boost/math/special_functions/ellint_rf.hpp>

#include <cmath>

namespace rigid {

double nutation_period(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
  const double u = std::cos(theta), s2 = std::sin(theta) * std::sin(theta);
  const double a = s2 * rates[0], b = I3 * (rates[0] * u + rates[2]) / I1;  // p_φ − p_ψ cos θ and p_ψ, over I₁
  const double beta = 2 * mgl / I1, energy = s2 * rates[0] * rates[0] + rates[1] * rates[1];

  // The square of d(cos θ)/dt where cos θ = u + d
  const double linear = -beta * s2 - 2 * u * energy + 2 * a * b, quadratic = 2 * u * beta - energy - b * b;
  const auto root_towards = [&](double vertical) {
    double inside = 0, outside = vertical - u;
    for (int halving = 0; halving < 100; ++halving) {
      const double d = (inside + outside) / 2;
      const double square = ((beta * d + quadratic) * d + linear) * d + s2 * rates[1] * rates[1];
      (square > 0 ? inside : outside) = d;
    }
    return inside;
  };
  const double low = root_towards(-1), high = root_towards(1);  // of the cubic; the third follows from their sum
  const double third_to_low = -quadratic - beta * (2 * low + high), third_to_high = third_to_low - beta * (high - low);
  return 4 * boost::math::ellint_rf(0.0, third_to_high, third_to_low);  // 4 K(m)/√third_to_low
}

}  // namespace rigid
