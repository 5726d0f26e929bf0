#include "rigid/rotating_frames.hpp"

#include <cmath>

namespace rigid {

Vector3d coriolis_acceleration(const Vector3d& v_enu, double latitude, double earth_rate) {
  const Vector3d rotation =
      earth_rate * Vector3d(0, std::cos(latitude), std::sin(latitude));  // the Earth's axis: no part east
  return -2 * rotation.cross(v_enu);
}

}  // namespace rigid
