//! wrong: the slow root as a difference
#include <cmath>
#include <rigid/heavy_top.hpp>
#include <utility>
namespace rigid {
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  const double a = I1 * std::cos(theta), b = I3 * omega3, root = std::sqrt(b * b - 4 * a * mgl);
  double x = (b - root) / (2 * a), y = (b + root) / (2 * a);
  if (std::abs(x) > std::abs(y)) std::swap(x, y);
  return {x, y};
}
}  // namespace rigid

//! wrong: smaller first, signs included
#include <algorithm>
#include <cmath>
#include <rigid/heavy_top.hpp>
namespace rigid {
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  const double a = I1 * std::cos(theta), b = I3 * omega3;
  const double q = (b + std::copysign(std::sqrt(b * b - 4 * a * mgl), b)) / 2;
  return {std::min(q / a, mgl / q), std::max(q / a, mgl / q)};
}
}  // namespace rigid

//! wrong: thinks of a positive spin only
#include <cmath>
#include <rigid/heavy_top.hpp>
namespace rigid {
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  const double a = I1 * std::cos(theta), b = I3 * omega3;
  const double q = b + std::sqrt(b * b - 4 * a * mgl);
  return {2 * mgl / q, q / (2 * a)};
}
}  // namespace rigid

//! wrong: divided by a, not by 2a
#include <cmath>
#include <rigid/heavy_top.hpp>
namespace rigid {
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  const double a = I1 * std::cos(theta), b = I3 * omega3;
  const double fast = (b + std::copysign(std::sqrt(b * b - 4 * a * mgl), b)) / a;
  return {mgl / (a * fast), fast};
}
}  // namespace rigid

//! wrong: single precision
#include <cmath>
#include <rigid/heavy_top.hpp>
namespace rigid {
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  const float a = I1 * std::cos(theta), b = I3 * omega3;
  const float q = 0.5f * (b + std::copysign(std::sqrt(b * b - 4 * a * static_cast<float>(mgl)), b));
  return {mgl / q, q / a};
}
}  // namespace rigid

//! wrong: only I1 - I3 resists, as if omega3 were the rate of psi
#include <cmath>
#include <rigid/heavy_top.hpp>
namespace rigid {
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  const double a = (I1 - I3) * std::cos(theta), b = I3 * omega3;
  const double q = (b + std::copysign(std::sqrt(b * b - 4 * a * mgl), b)) / 2;
  return {mgl / q, q / a};
}
}  // namespace rigid

//! wrong: torque with sine, the angle never drops out
#include <cmath>
#include <rigid/heavy_top.hpp>
namespace rigid {
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  const double a = I1 * std::cos(theta), b = I3 * omega3, c = mgl * std::sin(theta);
  const double q = (b + std::copysign(std::sqrt(b * b - 4 * a * c), b)) / 2;
  return {c / q, q / a};
}
}  // namespace rigid

//! right: Newton's rule for the slow one, their sum for the fast one
#include <cmath>
#include <rigid/heavy_top.hpp>
namespace rigid {
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  const double a = I1 * std::cos(theta), b = I3 * omega3;
  double x = 0;
  for (int i = 0; i < 100; ++i) x -= (a * x * x - b * x + mgl) / (2 * a * x - b);
  return {x, b / a - x};
}
}  // namespace rigid

//! right: one over the rate is the root of another quadratic
#include <cmath>
#include <rigid/heavy_top.hpp>
#include <utility>
namespace rigid {
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  // with φ̇ = b/a · x: x² − x + q = 0
  const double a = I1 * std::cos(theta), b = I3 * omega3, q = a * mgl / (b * b);
  const double larger = 0.5 + std::sqrt(0.25 - q), smaller = q / larger;
  return {b / a * smaller, b / a * larger};
}
}  // namespace rigid
