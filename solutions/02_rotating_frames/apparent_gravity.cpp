#include "rigid/rotating_frames.hpp"

#include <cmath>

namespace rigid {

Vector3d apparent_gravity(double latitude, double radius, double g0, double earth_rate, const Vector2d& v) {
  const Vector3d up(0, 0, 1), velocity(v.x(), v.y(), 0);
  const Vector3d rotation = earth_rate * Vector3d(0, std::cos(latitude), std::sin(latitude));
  // A great circle drawn on the planet curves towards its centre, for those on the planet too.
  const Vector3d on_the_planet = -velocity.squaredNorm() / radius * up;
  const Vector3d ship = on_the_planet + 2 * rotation.cross(velocity) + rotation.cross(rotation.cross(radius * up));
  return -g0 * up - ship;
}

}  // namespace rigid
