#include "rigid/euler_angles.hpp"

#include <cmath>

namespace rigid {

Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates) {
  const double phi = angles[0], theta = angles[1];
  // The three axes of rotation, in inertial components.
  const Vector3d nodes(-std::sin(phi), std::cos(phi), 0);
  const Vector3d body_axis(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  return rates[0] * Vector3d::UnitZ() + rates[1] * nodes + rates[2] * body_axis;
}

}  // namespace rigid
