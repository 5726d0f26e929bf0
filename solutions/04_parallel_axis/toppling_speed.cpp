#include "rigid/parallel_axis.hpp"

#include <cmath>

namespace rigid {

double toppling_speed(double length, double height, double g) {
  const double diagonal = std::hypot(length, height);
  // Half of diagonal − height, without the difference of two nearly equal numbers for a tall post.
  const double rise = length * length / (diagonal + height) / 2;
  const double square_of_gyration = diagonal * diagonal / 3;  // about the edge
  const double omega = std::sqrt(2 * g * rise / square_of_gyration);
  return square_of_gyration * omega / (height / 2);
}

}  // namespace rigid
