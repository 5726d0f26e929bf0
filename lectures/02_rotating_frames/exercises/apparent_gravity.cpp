// The gravity that a plumb line and a scale register aboard a ship that sails along a great circle of a rotating
// spherical planet: components east, north, up.
#include <rigid/rotating_frames.hpp>

namespace rigid {

Vector3d apparent_gravity(double latitude, double radius, double g0, double earth_rate, const Vector2d& v) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
