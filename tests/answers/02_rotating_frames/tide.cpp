#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/rotating_frames.hpp>
double tide(double mass_ratio, double radius, double distance, double angle) {
//! right: Newton on the potential as it stands
  // units: G M = 1
  auto potential = [&](double r, double gamma) {
    const double c = std::cos(gamma);
    return -1 / r - mass_ratio / std::sqrt(r * r + distance * distance - 2 * r * distance * c) +
           mass_ratio * r * c / (distance * distance);
  };
  const double level = potential(radius, std::numbers::pi / 2);
  double r = radius;
  for (int i = 0; i < 20; ++i) {
    const double h = 1e-4 * radius, slope = (potential(r + h, angle) - potential(r - h, angle)) / (2 * h);
    r -= (potential(r, angle) - level) / slope;
  }
  return r - radius;
//! wrong: moon and planet only
-    return -1 / r - mass_ratio / std::sqrt(r * r + distance * distance - 2 * r * distance * c) +
-           mass_ratio * r * c / (distance * distance);
+    return -1 / r - mass_ratio / std::sqrt(r * r + distance * distance - 2 * r * distance * c);
//! wrong: uniform field with the opposite sign
-    return -1 / r - mass_ratio / std::sqrt(r * r + distance * distance - 2 * r * distance * c) +
+    return -1 / r - mass_ratio / std::sqrt(r * r + distance * distance - 2 * r * distance * c) -
//! wrong: the level of the planet alone, without the moon
-  const double level = potential(radius, std::numbers::pi / 2);
+  const double level = -1 / radius - mass_ratio / distance;
//! right: bisection with the constant taken off
  const double x = radius / distance;
  auto f = [&](double h, double c) {
    const double y = x * (1 + h);
    return 1 / (1 + h) - 1 + mass_ratio * x * (1 / std::sqrt(1 + y * y - 2 * y * c) - 1 - y * c);
  };
  const double zero = f(0, 0), c = std::cos(angle);
  double low = -0.05, high = 0.05;
  for (int i = 0; i < 100; ++i) {
    const double mid = 0.5 * (low + high);
    if (f(mid, c) > zero) {
      low = mid;
    } else {
      high = mid;
    }
  }
  return low * radius;
//! wrong: textbook formula
  const double c = std::cos(angle);
  return 1.5 * mass_ratio * std::pow(radius / distance, 3) * radius * c * c;
//! wrong: height over the mean level
  const double c = std::cos(angle);
  return 0.5 * mass_ratio * std::pow(radius / distance, 3) * radius * (3 * c * c - 1);
//! wrong: two terms of the series
  const double c = std::cos(angle), x = radius / distance;
  return mass_ratio * x * x * x * radius * (1.5 * c * c + x * (2.5 * c * c * c - 1.5 * c));
//! wrong: one high water only
  const double u = radius / distance;
  return mass_ratio * radius * u * u * u * 1.5 * std::cos(angle);
