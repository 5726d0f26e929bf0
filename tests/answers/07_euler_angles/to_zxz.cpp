#include <cmath>
#include <numbers>
#include <rigid/euler_angles.hpp>
Vector3d to_zxz(const Vector3d& angles) {
//! right: from the matrix
  const double pi = std::numbers::pi;
  const double cp = std::cos(angles[0]), sp = std::sin(angles[0]), ct = std::cos(angles[1]), st = std::sin(angles[1]);
  const double cs = std::cos(angles[2]), ss = std::sin(angles[2]);
  const double theta = std::atan2(std::abs(st), ct);
  if (std::abs(st) < 1e-9) return {std::atan2(sp * cs * ct + cp * ss, cp * cs * ct - sp * ss), theta, 0};
  return {std::atan2(st * cp, -st * sp), theta, std::atan2(-st * cs, st * ss)};
//! right: loops until in range
  const double pi = std::numbers::pi;
  double phi = angles[0] + pi / 2, theta = angles[1], psi = angles[2] - pi / 2;
  while (theta > pi + 1e-9) theta -= 2 * pi;
  while (theta < -pi - 1e-9) theta += 2 * pi;
  if (theta < 0) {
    theta = -theta;
    phi += pi;
    psi -= pi;
  }
  if (std::abs(std::sin(theta)) < 1e-8) {
    phi = std::cos(theta) > 0 ? phi + psi : phi - psi;
    psi = 0;
  }
  while (phi > pi) phi -= 2 * pi;
  while (phi <= -pi) phi += 2 * pi;
  while (psi > pi) psi -= 2 * pi;
  while (psi <= -pi) psi += 2 * pi;
  return {phi, theta, psi};
//! wrong: no ranges
  const double pi = std::numbers::pi;
  return {angles[0] + pi / 2, angles[1], angles[2] - pi / 2};
//! wrong: signs of the quarter turns
  const double pi = std::numbers::pi;
  Vector3d q(angles[0] - pi / 2, std::remainder(angles[1], 2 * pi), angles[2] + pi / 2);
  if (q[1] < 0) q = Vector3d(q[0] + pi, -q[1], q[2] + pi);
  if (std::sin(q[1]) < 1e-9) q = Vector3d(q[1] < 1 ? q[0] + q[2] : q[0] - q[2], q[1], 0);
  return {std::remainder(q[0], 2 * pi), q[1], std::remainder(q[2], 2 * pi)};
//! wrong: upside down like upright
  const double pi = std::numbers::pi;
  Vector3d q(angles[0] + pi / 2, std::remainder(angles[1], 2 * pi), angles[2] - pi / 2);
  if (q[1] < 0) q = Vector3d(q[0] + pi, -q[1], q[2] + pi);
  if (std::sin(q[1]) < 1e-9) q = Vector3d(q[0] + q[2], q[1], 0);
  return {std::remainder(q[0], 2 * pi), q[1], std::remainder(q[2], 2 * pi)};
//! wrong: nothing special at the vertical
-  if (std::sin(q[1]) < 1e-9) q = Vector3d(q[0] + q[2], q[1], 0);
//! right: by the matrix
  using A = Eigen::AngleAxisd;
  const Vector3d x = Vector3d::UnitX(), z = Vector3d::UnitZ();
  const Matrix3d m = (A(angles[0], z) * A(angles[1], Vector3d::UnitY()) * A(angles[2], z)).toRotationMatrix();
  (void)x;
  const double s = std::hypot(m(0, 2), m(1, 2));
  if (s < 1e-9) return {std::atan2(m(1, 0), m(0, 0)), m(2, 2) > 0 ? 0.0 : std::numbers::pi, 0.0};
  return {std::atan2(m(0, 2), -m(1, 2)), std::atan2(s, m(2, 2)), std::atan2(m(2, 0), m(2, 1))};
//! wrong: brought into range by fmod, which keeps the sign
  const double pi = std::numbers::pi;
  double f = angles[0] + pi / 2, th = std::remainder(angles[1], 2 * pi), p = angles[2] - pi / 2;
  if (th < 0) {
    th = -th;
    f += pi;
    p += pi;
  }
  if (std::abs(std::sin(th)) < 1e-9) {
    f += std::cos(th) > 0 ? p : -p;
    p = 0;
  }
  return {std::fmod(f + pi, 2 * pi) - pi, th, std::fmod(p + pi, 2 * pi) - pi};
