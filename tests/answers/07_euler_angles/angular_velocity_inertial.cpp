//! wrong: body components
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  return {-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]};
}
}  // namespace rigid

//! wrong: sign of the line of nodes
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sf = std::sin(angles[0]), cf = std::cos(angles[0]);
  return {rates[1] * sf + rates[2] * s * cf, rates[1] * cf + rates[2] * s * sf, rates[0] + rates[2] * c};
}
}  // namespace rigid

//! wrong: psi in place of phi
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sf = std::sin(angles[2]), cf = std::cos(angles[2]);
  return {-rates[1] * sf + rates[2] * s * cf, rates[1] * cf + rates[2] * s * sf, rates[0] + rates[2] * c};
}
}  // namespace rigid

//! wrong: rates of phi and psi exchanged
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sf = std::sin(angles[0]), cf = std::cos(angles[0]);
  return {-rates[1] * sf + rates[0] * s * cf, rates[1] * cf + rates[0] * s * sf, rates[2] + rates[0] * c};
}
}  // namespace rigid

//! wrong: the line of nodes along x
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sf = std::sin(angles[0]), cf = std::cos(angles[0]);
  return {rates[1] * cf + rates[2] * s * cf, rates[1] * sf + rates[2] * s * sf, rates[0] + rates[2] * c};
}
}  // namespace rigid

//! right: three components
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sf = std::sin(angles[0]), cf = std::cos(angles[0]);
  return {-rates[1] * sf + rates[2] * s * cf, rates[1] * cf + rates[2] * s * sf, rates[0] + rates[2] * c};
}
}  // namespace rigid

//! right: body components, rotated back
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates) {
  using Eigen::AngleAxisd;
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d omega(-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]);
  return AngleAxisd(angles[0], Vector3d::UnitZ()) *
         (AngleAxisd(angles[1], Vector3d::UnitY()) * (AngleAxisd(angles[2], Vector3d::UnitZ()) * omega));
}
}  // namespace rigid
