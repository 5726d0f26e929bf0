#include <algorithm>
#include <cmath>
#include <utility>
#include <rigid/heavy_top.hpp>
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
//! right: Newton's rule for the slow one, their sum for the fast one
  const double a = I1 * std::cos(theta), b = I3 * omega3;
  double x = 0;
  for (int i = 0; i < 100; ++i) x -= (a * x * x - b * x + mgl) / (2 * a * x - b);
  return {x, b / a - x};
//! right: one over the rate is the root of another quadratic
  // with φ̇ = b/a · x: x² − x + q = 0
  const double a = I1 * std::cos(theta), b = I3 * omega3, q = a * mgl / (b * b);
  const double larger = 0.5 + std::sqrt(0.25 - q), smaller = q / larger;
  return {b / a * smaller, b / a * larger};
//! wrong: the slow root as a difference
  const double a = I1 * std::cos(theta), b = I3 * omega3, root = std::sqrt(b * b - 4 * a * mgl);
  double x = (b - root) / (2 * a), y = (b + root) / (2 * a);
  if (std::abs(x) > std::abs(y)) std::swap(x, y);
  return {x, y};
//! wrong: smaller first, signs included
  const double a = I1 * std::cos(theta), b = I3 * omega3;
  const double q = (b + std::copysign(std::sqrt(b * b - 4 * a * mgl), b)) / 2;
  return {std::min(q / a, mgl / q), std::max(q / a, mgl / q)};
//! wrong: thinks of a positive spin only
  const double a = I1 * std::cos(theta), b = I3 * omega3;
  const double q = b + std::sqrt(b * b - 4 * a * mgl);
  return {2 * mgl / q, q / (2 * a)};
//! wrong: divided by a, not by 2a
  const double a = I1 * std::cos(theta), b = I3 * omega3;
  const double fast = (b + std::copysign(std::sqrt(b * b - 4 * a * mgl), b)) / a;
  return {mgl / (a * fast), fast};
//! wrong: single precision
  const float a = I1 * std::cos(theta), b = I3 * omega3;
  const float q = 0.5f * (b + std::copysign(std::sqrt(b * b - 4 * a * static_cast<float>(mgl)), b));
  return {mgl / q, q / a};
//! wrong: only I1 - I3 resists, as if omega3 were the rate of psi
  const double a = (I1 - I3) * std::cos(theta), b = I3 * omega3;
  const double q = (b + std::copysign(std::sqrt(b * b - 4 * a * mgl), b)) / 2;
  return {mgl / q, q / a};
//! wrong: torque with sine, the angle never drops out
  const double a = I1 * std::cos(theta), b = I3 * omega3, c = mgl * std::sin(theta);
  const double q = (b + std::copysign(std::sqrt(b * b - 4 * a * c), b)) / 2;
  return {c / q, q / a};
//! wrong: no cosine in the slow rate
  const double a = I1, b = I3 * omega3, q = mgl;
  const double root = std::sqrt(b * b - 4 * a * q * std::cos(theta));
  const double big = (b + std::copysign(root, b)) / (2 * a * std::cos(theta));
  const double small = q / (a * big);
  return {small, big};
//! wrong: minus before plus: another order, and lost digits
  const double a = I1 * std::cos(theta), b = I3 * omega3, r = std::sqrt(b * b - 4 * a * mgl);
  return {(b - r) / (2 * a), (b + r) / (2 * a)};
