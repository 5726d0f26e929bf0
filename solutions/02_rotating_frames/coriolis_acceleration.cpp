#include "rigid/rotating_frames.hpp"

#include <cmath>

namespace rigid {

Vector3d coriolis_acceleration(const Vector3d& v_enu, double latitude, double earth_rate) {
  // The Earth's axis lies in the plane of north and up.
  const Vector3d rotation = earth_rate * Vector3d(0, std::cos(latitude), std::sin(latitude));
  return -2 * rotation.cross(v_enu);
}

}  // namespace rigid
