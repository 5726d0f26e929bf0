#include <cmath>
#include <rigid/euler_angles.hpp>
Vector3d angular_velocity_body(const Vector3d& angles, const Vector3d& rates) {
//! right: three components
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  return {-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]};
//! wrong: sine and cosine of psi exchanged in the line of nodes
-  return {-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]};
+  return {-rates[0] * s * cp + rates[1] * cp, rates[0] * s * sp + rates[1] * sp, rates[0] * c + rates[2]};
//! wrong: sign of the first term
-  return {-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]};
+  return {rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]};
//! wrong: z-x-z of the other books
-  return {-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]};
+  return {rates[0] * s * sp + rates[1] * cp, rates[0] * s * cp - rates[1] * sp, rates[0] * c + rates[2]};
//! wrong: phi in place of psi
-  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
+  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[0]), cp = std::cos(angles[0]);
//! wrong: whole numbers for sine and cosine
-  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
+  const int s = std::sin(angles[1]), c = std::cos(angles[1]);
+  const double sp = std::sin(angles[2]), cp = std::cos(angles[2]);
//! right: one axis after another is rotated
  using Eigen::AngleAxisd;
  const Matrix3d Rz = AngleAxisd(-angles[2], Vector3d::UnitZ()).toRotationMatrix();
  const Matrix3d Ry = AngleAxisd(-angles[1], Vector3d::UnitY()).toRotationMatrix();
  Vector3d omega = rates[0] * Vector3d::UnitZ();
  omega = Ry * omega + rates[1] * Vector3d::UnitY();
  omega = Rz * omega + rates[2] * Vector3d::UnitZ();
  return omega;
//! wrong: projection of the vertical on the third axis forgotten
  const double s = std::sin(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  return {-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] + rates[2]};
//! wrong: the rates as if they were components
Vector3d angular_velocity_body(const Vector3d& angles, const Vector3d& rates) { return {rates[0], rates[1], rates[2]}; }
