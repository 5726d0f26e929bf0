//! wrong: sign of the rate of phi
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d& w = omega_body;
  const double phi = (w[0] * cp - w[1] * sp) / s;
  return {phi, w[0] * sp + w[1] * cp, w[2] - c * phi};
}
}  // namespace rigid

//! wrong: not divided by the sine
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const double c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d& w = omega_body;
  const double phi = -w[0] * cp + w[1] * sp;
  return {phi, w[0] * sp + w[1] * cp, w[2] - c * phi};
}
}  // namespace rigid

//! wrong: the matrix transposed in place of inverted
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  Matrix3d B;
  B << -s * cp, sp, 0, s * sp, cp, 0, c, 0, 1;
  return B.transpose() * omega_body;
}
}  // namespace rigid

//! wrong: size of the sine
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const double s = std::abs(std::sin(angles[1])), c = std::cos(angles[1]);
  const double sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d& w = omega_body;
  const double phi = (-w[0] * cp + w[1] * sp) / s;
  return {phi, w[0] * sp + w[1] * cp, w[2] - c * phi};
}
}  // namespace rigid

//! wrong: gives up too early close to the vertical
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d& w = omega_body;
  if (std::abs(s) < 1e-3) return {0, w[0] * sp + w[1] * cp, w[2]};
  const double phi = (-w[0] * cp + w[1] * sp) / s;
  return {phi, w[0] * sp + w[1] * cp, w[2] - c * phi};
}
}  // namespace rigid

//! wrong: the rate of phi does not reach that of psi
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const double s = std::sin(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d& w = omega_body;
  return {(-w[0] * cp + w[1] * sp) / s, w[0] * sp + w[1] * cp, w[2]};
}
}  // namespace rigid

//! wrong: sine and cosine of psi exchanged
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::cos(angles[2]), cp = std::sin(angles[2]);
  const Vector3d& w = omega_body;
  const double phi = (-w[0] * cp + w[1] * sp) / s;
  return {phi, w[0] * sp + w[1] * cp, w[2] - c * phi};
}
}  // namespace rigid

//! right: reciprocal axes
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d vertical(-s * cp, s * sp, c), nodes(sp, cp, 0), third = Vector3d::UnitZ();
  const double volume = vertical.dot(nodes.cross(third));
  return {omega_body.dot(nodes.cross(third)) / volume, omega_body.dot(third.cross(vertical)) / volume,
          omega_body.dot(vertical.cross(nodes)) / volume};
}
}  // namespace rigid

//! right: rotated to the line of nodes first
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const Vector3d w = Eigen::AngleAxisd(angles[2], Vector3d::UnitZ()) * omega_body;
  const double phi = -w.x() / std::sin(angles[1]);
  return {phi, w.y(), w.z() - std::cos(angles[1]) * phi};
}
}  // namespace rigid

//! right: linear equations
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  Matrix3d B;
  B << -s * cp, sp, 0, s * sp, cp, 0, c, 0, 1;
  return B.colPivHouseholderQr().solve(omega_body);
}
}  // namespace rigid
