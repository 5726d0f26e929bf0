//! wrong: energy conserved in the impact
#include "rigid/parallel_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

double toppling_speed(double length, double height, double g) {
  const double rise = (std::hypot(length, height) - height) / 2;
  return std::sqrt(2 * g * rise);
}

}  // namespace rigid
//! wrong: inertia about the middle
#include "rigid/parallel_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

double toppling_speed(double length, double height, double g) {
  const double d2 = length * length + height * height;
  const double rise = (std::sqrt(d2) - height) / 2;
  const double k = d2 / 12;
  return k * std::sqrt(2 * g * rise / k) / (height / 2);
}

}  // namespace rigid
//! wrong: lever of half the length
#include "rigid/parallel_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

double toppling_speed(double length, double height, double g) {
  const double d2 = length * length + height * height;
  const double rise = (std::sqrt(d2) - height) / 2;
  const double k = d2 / 3;
  return k * std::sqrt(2 * g * rise / k) / (length / 2);
}

}  // namespace rigid
//! wrong: whole diagonal raised
#include "rigid/parallel_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

double toppling_speed(double length, double height, double g) {
  const double d2 = length * length + height * height;
  const double rise = std::sqrt(d2) - height;
  const double k = d2 / 3;
  return k * std::sqrt(2 * g * rise / k) / (height / 2);
}

}  // namespace rigid
