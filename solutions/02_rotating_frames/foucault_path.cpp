#include "rigid/rotating_frames.hpp"

#include <cmath>

namespace rigid {

Vector2d foucault_path(const Vector2d& start, double length, double g, double latitude, double earth_rate, double t) {
  const double vertical = earth_rate * std::sin(latitude);
  const double swing = std::sqrt(g / length + vertical * vertical);
  // In a frame that rotates clockwise with `vertical` there is no Coriolis force, and the pendulum is an ordinary one.
  // There the bob, at rest on the floor, has a sideways velocity when it is released.
  const Vector2d sideways = vertical * Vector2d(-start.y(), start.x());
  const Vector2d position = std::cos(swing * t) * start + std::sin(swing * t) / swing * sideways;
  return Eigen::Rotation2Dd(-vertical * t) * position;
}

}  // namespace rigid
