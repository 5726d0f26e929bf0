#include <cmath>
#include <rigid/euler_angles.hpp>
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
//! right: reciprocal axes
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d vertical(-s * cp, s * sp, c), nodes(sp, cp, 0), third = Vector3d::UnitZ();
  const double volume = vertical.dot(nodes.cross(third));
  return {omega_body.dot(nodes.cross(third)) / volume, omega_body.dot(third.cross(vertical)) / volume,
          omega_body.dot(vertical.cross(nodes)) / volume};
//! right: rotated to the line of nodes first
  const Vector3d w = Eigen::AngleAxisd(angles[2], Vector3d::UnitZ()) * omega_body;
  const double phi = -w.x() / std::sin(angles[1]);
  return {phi, w.y(), w.z() - std::cos(angles[1]) * phi};
//! right: linear equations
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  Matrix3d B;
  B << -s * cp, sp, 0, s * sp, cp, 0, c, 0, 1;
  return B.colPivHouseholderQr().solve(omega_body);
//! wrong: the matrix transposed in place of inverted
-  return B.colPivHouseholderQr().solve(omega_body);
+  return B.transpose() * omega_body;
//! wrong: sign of the rate of phi
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d& w = omega_body;
  const double phi = (w[0] * cp - w[1] * sp) / s;
  return {phi, w[0] * sp + w[1] * cp, w[2] - c * phi};
//! wrong: gives up too early close to the vertical
-  const double phi = (w[0] * cp - w[1] * sp) / s;
+  if (std::abs(s) < 1e-3) return {0, w[0] * sp + w[1] * cp, w[2]};
+  const double phi = (-w[0] * cp + w[1] * sp) / s;
//! wrong: not divided by the sine
  const double c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d& w = omega_body;
  const double phi = -w[0] * cp + w[1] * sp;
  return {phi, w[0] * sp + w[1] * cp, w[2] - c * phi};
//! wrong: the rate of phi does not reach that of psi
  const double s = std::sin(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d& w = omega_body;
  return {(-w[0] * cp + w[1] * sp) / s, w[0] * sp + w[1] * cp, w[2]};
//! wrong: sine and cosine of psi exchanged
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::cos(angles[2]), cp = std::sin(angles[2]);
  const Vector3d& w = omega_body;
  const double phi = (-w[0] * cp + w[1] * sp) / s;
  return {phi, w[0] * sp + w[1] * cp, w[2] - c * phi};
//! wrong: size of the sine
-  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::cos(angles[2]), cp = std::sin(angles[2]);
+  const double s = std::abs(std::sin(angles[1])), c = std::cos(angles[1]);
+  const double sp = std::sin(angles[2]), cp = std::cos(angles[2]);
