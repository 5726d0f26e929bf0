#include "rigid/heavy_top.hpp"

#include <cmath>

namespace rigid {

Vector2d nutation_limits(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
  const double u = std::cos(theta), s2 = std::sin(theta) * std::sin(theta);
  const double a = s2 * rates[0], b = I3 * (rates[0] * u + rates[2]) / I1;  // p_φ − p_ψ cos θ and p_ψ, over I₁
  const double beta = 2 * mgl / I1, energy = s2 * rates[0] * rates[0] + rates[1] * rates[1];

  // The square of d(cos θ)/dt where cos θ = u + d. At the start, d = 0, it is positive or zero; at the vertical,
  // negative.
  const auto squared_rate = [&](double d) {
    const double linear = -beta * s2 - 2 * u * energy + 2 * a * b, quadratic = 2 * u * beta - energy - b * b;
    return ((beta * d + quadratic) * d + linear) * d + s2 * rates[1] * rates[1];
  };
  const auto limit_towards = [&](double vertical) {
    double inside = 0, outside = vertical - u;
    for (int halving = 0; halving < 100; ++halving) {
      const double middle = (inside + outside) / 2;
      (squared_rate(middle) > 0 ? inside : outside) = middle;
    }
    return std::acos(u + inside);
  };
  return {limit_towards(1), limit_towards(-1)};
}

}  // namespace rigid
