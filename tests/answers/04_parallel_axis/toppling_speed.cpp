#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/parallel_axis.hpp>
double toppling_speed(double length, double height, double g) {
//! wrong: energy conserved in the impact
  const double rise = (std::hypot(length, height) - height) / 2;
  return std::sqrt(2 * g * rise);
//! wrong: inertia about the middle
  const double d2 = length * length + height * height;
  const double rise = (std::sqrt(d2) - height) / 2;
  const double k = d2 / 12;
  return k * std::sqrt(2 * g * rise / k) / (height / 2);
//! wrong: lever of half the length
  const double d2 = length * length + height * height;
  const double rise = (std::sqrt(d2) - height) / 2;
  const double k = d2 / 3;
  return k * std::sqrt(2 * g * rise / k) / (length / 2);
//! wrong: whole diagonal raised
  const double d2 = length * length + height * height;
  const double rise = std::sqrt(d2) - height;
  const double k = d2 / 3;
  return k * std::sqrt(2 * g * rise / k) / (height / 2);
