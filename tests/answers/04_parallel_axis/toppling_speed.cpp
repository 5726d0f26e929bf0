#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/parallel_axis.hpp>
//! wrong: energy conserved in the impact
double toppling_speed(double length, double height, double g) {
  const double rise = (std::hypot(length, height) - height) / 2;
  return std::sqrt(2 * g * rise);
}
//! wrong: inertia about the middle
double toppling_speed(double length, double height, double g) {
  const double d2 = length * length + height * height;
  const double rise = (std::sqrt(d2) - height) / 2;
  const double k = d2 / 12;
  return k * std::sqrt(2 * g * rise / k) / (height / 2);
}
//! wrong: lever of half the length
double toppling_speed(double length, double height, double g) {
  const double d2 = length * length + height * height;
  const double rise = (std::sqrt(d2) - height) / 2;
  const double k = d2 / 3;
  return k * std::sqrt(2 * g * rise / k) / (length / 2);
}
//! wrong: whole diagonal raised
double toppling_speed(double length, double height, double g) {
  const double d2 = length * length + height * height;
  const double rise = std::sqrt(d2) - height;
  const double k = d2 / 3;
  return k * std::sqrt(2 * g * rise / k) / (height / 2);
}
