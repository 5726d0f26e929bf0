#include <cmath>
#include <rigid/free_tops.hpp>
Vector2d linearized_top(const Vector3d& I, double omega3, double amplitude, double phase, double t) {
//! right: the second component from the rate of the first
  const double O1 = omega3 * (I[2] - I[1]) / I[0], O2 = omega3 * (I[2] - I[0]) / I[1];
  const double f = std::sqrt(O1 * O2);
  const double rate1 = -amplitude * f * std::sin(f * t + phase);
  return {amplitude * std::cos(f * t + phase), -rate1 / O1};
//! wrong: phase forgotten
  const double O1 = omega3 * (I[2] - I[1]) / I[0], O2 = omega3 * (I[2] - I[0]) / I[1];
  const double f = std::sqrt(O1 * O2);
  return amplitude * Vector2d(std::cos(f * t), f / O1 * std::sin(f * t));
//! right: from the values at the beginning, by the addition theorems
  const double O1 = omega3 * (I[2] - I[1]) / I[0], O2 = omega3 * (I[2] - I[0]) / I[1];
  const double f = std::sqrt(O1 * O2), ratio = std::copysign(std::sqrt(O2 / O1), O1);
  const double x = amplitude * std::cos(phase), y = amplitude * std::sin(phase);
  const double c = std::cos(f * t), s = std::sin(f * t);
  return {x * c - y * s, ratio * (y * c + x * s)};
//! wrong: ratio upside down
  const double O1 = omega3 * (I[2] - I[1]) / I[0], O2 = omega3 * (I[2] - I[0]) / I[1];
  const double sign = O1 > 0 ? 1 : -1;
  const double angle = std::sqrt(O1 * O2) * t + phase;
  return {amplitude * std::cos(angle), sign * amplitude * std::sqrt(O1 / O2) * std::sin(angle)};
//! wrong: frequency without its root
  const double O1 = omega3 * (I[2] - I[1]) / I[0], O2 = omega3 * (I[2] - I[0]) / I[1];
  const double angle = O1 * O2 * t + phase;
  return amplitude * Vector2d(std::cos(angle), std::copysign(std::sqrt(O2 / O1), O1) * std::sin(angle));
//! wrong: a circle, as for the symmetric top
  const double O1 = omega3 * (I[2] - I[1]) / I[0], O2 = omega3 * (I[2] - I[0]) / I[1];
  const double angle = std::sqrt(O1 * O2) * t + phase;
  return amplitude * Vector2d(std::cos(angle), std::copysign(1.0, O1) * std::sin(angle));
//! wrong: as on the slides, without the sign
-  return amplitude * Vector2d(std::cos(angle), std::copysign(1.0, O1) * std::sin(angle));
+  return {amplitude * std::cos(angle), amplitude * std::sqrt(O2 / O1) * std::sin(angle)};
//! wrong: the sign of the spin alone
-  return amplitude * Vector2d(std::cos(angle), std::copysign(1.0, O1) * std::sin(angle));
+  const double sign = omega3 < 0 ? -1 : 1;
+  return amplitude * Vector2d(std::cos(angle), sign * std::sqrt(O2 / O1) * std::sin(angle));
//! wrong: the sign as a whole number of the ratio
-  return amplitude * Vector2d(std::cos(angle), std::copysign(1.0, O1) * std::sin(angle));
+  const int sign = O1 / std::abs(O2);
+  return {amplitude * std::cos(angle), sign * amplitude * std::sqrt(O2 / O1) * std::sin(angle)};
