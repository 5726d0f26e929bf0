#include "rigid/measured.hpp"

#include <cmath>
#include <numbers>

namespace rigid {

Vector2d moment_from_pendulum(double M, double g, double d, double P, double d_error, double P_error) {
  constexpr double pi = std::numbers::pi;
  const double length = g * P * P / (4 * pi * pi);  // of the simple pendulum with this period
  // The distance stands in both parts of the moment, so its error enters once, with the derivative of their difference.
  const double from_distance = M * (length - 2 * d) * d_error, from_period = 2 * M * d * length / P * P_error;
  return {M * d * (length - d), std::hypot(from_distance, from_period)};
}

}  // namespace rigid
