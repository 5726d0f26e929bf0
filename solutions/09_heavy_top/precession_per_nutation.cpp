#include "rigid/heavy_top.hpp"

#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>

#include <cmath>

namespace rigid {

double precession_per_nutation(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
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
  const double low = root_towards(-1), high = root_towards(1);
  const double third_to_low = -quadratic - beta * (2 * low + high);
  const double complement = 1 - beta * (high - low) / third_to_low;  // 1 − m

  // φ̇ = (a − b d)/(1 − cos²θ) in partial fractions: one integral of the third kind for each end of the vertical
  const auto share = [&](double end) {  // (p_φ ∓ p_ψ)/I₁ over the distance of cos θ from ±1, integrated
    const double distance = 1 - end * (u + low), part = end * (high - low) / distance;
    const double third_kind = boost::math::ellint_rf(0.0, complement, 1.0) +
                              part / 3 * boost::math::ellint_rj(0.0, complement, 1.0, 1 - part);
    return (a + b * u - end * b) / distance * third_kind;
  };
  return 2 / std::sqrt(third_to_low) * (share(1) + share(-1));
}

}  // namespace rigid
