#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/parallel_axis.hpp>
double toppling_speed(double length, double height, double g) {
//! right: angular momentum about the edge, then energy
  const double d2 = length * length + height * height;
  const double rise = (std::sqrt(d2) - height) / 2;
  const double k = d2 / 3;
  return k * std::sqrt(2 * g * rise / k) / (height / 2);
//! wrong: inertia about the middle
-  const double k = d2 / 3;
+  const double k = d2 / 12;
//! wrong: lever of half the length
-  return k * std::sqrt(2 * g * rise / k) / (height / 2);
+  return k * std::sqrt(2 * g * rise / k) / (length / 2);
//! wrong: whole diagonal raised
-  const double rise = (std::sqrt(d2) - height) / 2;
+  const double rise = std::sqrt(d2) - height;
//! wrong: energy conserved in the impact
  const double rise = (std::hypot(length, height) - height) / 2;
  return std::sqrt(2 * g * rise);
//! wrong: no return where both are equal
  const double diagonal = std::hypot(length, height);
  const double v = std::sqrt(4 * g * diagonal * diagonal * (diagonal - height) / 3) / height;
  if (length != height) return v;
//! wrong: moment about the centre, and the rise of the whole diagonal
  const double d = std::hypot(length, height), I = d * d / 12;
  const double rate = std::sqrt(2 * g * (d / 2) / I);
  return rate * I / (height / 2);
