#include <cmath>
#include <rigid/euler_angles.hpp>
Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates) {
//! right: three components
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sf = std::sin(angles[0]), cf = std::cos(angles[0]);
  return {-rates[1] * sf + rates[2] * s * cf, rates[1] * cf + rates[2] * s * sf, rates[0] + rates[2] * c};
//! wrong: sign of the line of nodes
-  return {-rates[1] * sf + rates[2] * s * cf, rates[1] * cf + rates[2] * s * sf, rates[0] + rates[2] * c};
+  return {rates[1] * sf + rates[2] * s * cf, rates[1] * cf + rates[2] * s * sf, rates[0] + rates[2] * c};
//! wrong: psi in place of phi
-  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sf = std::sin(angles[0]), cf = std::cos(angles[0]);
+  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sf = std::sin(angles[2]), cf = std::cos(angles[2]);
//! wrong: rates of phi and psi exchanged
-  return {-rates[1] * sf + rates[2] * s * cf, rates[1] * cf + rates[2] * s * sf, rates[0] + rates[2] * c};
+  return {-rates[1] * sf + rates[0] * s * cf, rates[1] * cf + rates[0] * s * sf, rates[2] + rates[0] * c};
//! wrong: the line of nodes along x
-  return {-rates[1] * sf + rates[2] * s * cf, rates[1] * cf + rates[2] * s * sf, rates[0] + rates[2] * c};
+  return {rates[1] * cf + rates[2] * s * cf, rates[1] * sf + rates[2] * s * sf, rates[0] + rates[2] * c};
//! right: body components, rotated back
  using Eigen::AngleAxisd;
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d omega(-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]);
  return AngleAxisd(angles[0], Vector3d::UnitZ()) *
         (AngleAxisd(angles[1], Vector3d::UnitY()) * (AngleAxisd(angles[2], Vector3d::UnitZ()) * omega));
//! wrong: body components
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  return {-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]};
