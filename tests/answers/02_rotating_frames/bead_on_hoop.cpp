#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/rotating_frames.hpp>
Vector2d bead_on_hoop(double radius, double g, double rate) {
//! right: bottom or tilted
  const double w2 = rate * rate, k = g / radius;
  if (w2 <= k) return {0, std::sqrt(k - w2)};
  return {std::acos(k / w2), std::sqrt(w2 - k * k / w2)};
//! wrong: sine for cosine in the equilibrium
-  return {std::acos(k / w2), std::sqrt(w2 - k * k / w2)};
+  return {std::asin(k / w2), std::abs(rate) * std::sqrt(1 - k * k / w2 / w2)};
//! wrong: bottom frequency not lowered by the rotation
-  if (w2 <= k) return {0, std::sqrt(k - w2)};
+  if (w2 <= k) return {0, std::sqrt(k)};
//! wrong: negative rate gives a negative frequency
-  return {std::acos(k / w2), std::sqrt(w2 - k * k / w2)};
+  return {std::acos(k / w2), rate * std::sqrt(1 - k * k / (w2 * w2))};
//! wrong: a negative rate taken for a slow one
-  if (w2 <= k) return {0, std::sqrt(k - w2)};
+  if (rate < std::sqrt(k)) return {0, std::sqrt(std::abs(k - w2))};
//! wrong: critical rate without the root
  if (rate < g / radius) return {0, std::sqrt(std::abs(g / radius - rate * rate))};
  const double c = g / (rate * rate * radius);
  return {std::acos(c), rate * std::sqrt(1 - c * c)};
//! wrong: frequency squared
  const double w2 = rate * rate, k = g / radius;
  if (w2 <= k) return {0, k - w2};
  return {std::acos(k / w2), w2 - k * k / w2};
//! wrong: frequency without the sine
  const double q = g / (radius * rate * rate);
  if (q >= 1) return {0, std::sqrt(g / radius - rate * rate)};
  return {std::acos(q), std::abs(rate)};
//! wrong: rate not squared in the cosine
  if (rate * rate <= g / radius) return {0, std::sqrt(g / radius - rate * rate)};
  const double c = g / (radius * std::abs(rate));
  const double a = std::acos(std::min(c, 1.0));
  return {a, std::abs(rate) * std::sin(a)};
//! wrong: the centrifugal force of the whole radius, at every rate
  const double theta = std::atan(rate * rate * radius / g);
  return {theta, std::sqrt(g / radius * std::cos(theta) + rate * rate * std::sin(theta))};
