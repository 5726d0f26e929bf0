#include "rigid/euler_angles.hpp"

#include <cmath>

namespace rigid {

Vector3d angular_velocity_body(const Vector3d& angles, const Vector3d& rates) {
  const double theta = angles[1], psi = angles[2];
  // The three axes of rotation, in body components. φ is missing: the body does not see which way is north.
  const Vector3d vertical(-std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta));
  const Vector3d nodes(std::sin(psi), std::cos(psi), 0);
  return rates[0] * vertical + rates[1] * nodes + rates[2] * Vector3d::UnitZ();
}

}  // namespace rigid
