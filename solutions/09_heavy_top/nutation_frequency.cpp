#include "rigid/heavy_top.hpp"

#include <cmath>

namespace rigid {

double nutation_frequency(double I1, double mgl, double theta, double rate) {
  // φ̇² − 2w cos θ + (w/φ̇)² with w = mgl/I₁, as a sum of squares
  const double w = mgl / I1;
  return std::hypot(std::abs(rate) - w / std::abs(rate), 2 * std::sqrt(w) * std::sin(theta / 2));
}

}  // namespace rigid
