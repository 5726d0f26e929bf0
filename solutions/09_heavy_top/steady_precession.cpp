#include "rigid/heavy_top.hpp"

#include <cmath>

namespace rigid {

Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  // θ̈ = 0: a φ̇² − b φ̇ + mgl = 0
  const double a = I1 * std::cos(theta), b = I3 * omega3;
  const double larger = (b + std::copysign(std::sqrt(b * b - 4 * a * mgl), b)) / 2;  // nothing is subtracted from b
  return {mgl / larger, larger / a};
}

}  // namespace rigid
