#include <cmath>
#include <rigid/euler_angles.hpp>
Vector3d euler_angles(const Matrix3d& R_body_from_inertial) {
//! right: the library's angles, brought into the range
  Vector3d a = Matrix3d(R_body_from_inertial.transpose()).eulerAngles(2, 1, 2);
  if (a[1] < 0) {
    a[0] += M_PI;
    a[1] = -a[1];
    a[2] += M_PI;
  }
  return a;
//! right: the two degenerate attitudes on their own
  const Matrix3d& R = R_body_from_inertial;
  const double s = std::hypot(R(2, 0), R(2, 1));
  const double theta = std::atan2(s, R(2, 2));
  if (s < 1e-12) return {0, theta, std::atan2(R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 0)), theta, std::atan2(R(1, 2), -R(0, 2))};
//! wrong: angles of the inverse
  const Matrix3d R = R_body_from_inertial.transpose();
  const double theta = std::atan2(std::hypot(R(2, 0), R(2, 1)), R(2, 2));
  const double phi = std::atan2(R(2, 1), R(2, 0));
  const Vector3d nodes = R * Vector3d(-std::sin(phi), std::cos(phi), 0);
  return {phi, theta, std::atan2(nodes[0], nodes[1])};
//! wrong: sign in the third angle
  const Matrix3d& R = R_body_from_inertial;
  const double theta = std::acos(std::clamp(R(2, 2), -1.0, 1.0));
  if (std::hypot(R(2, 0), R(2, 1)) < 1e-12) return {std::atan2(R(0, 1), R(1, 1)), theta, 0};
  return {std::atan2(R(2, 1), R(2, 0)), theta, std::atan2(R(1, 2), R(0, 2))};
//! wrong: arguments of atan2 exchanged
  const Matrix3d& R = R_body_from_inertial;
  const double theta = std::atan2(std::hypot(R(2, 0), R(2, 1)), R(2, 2));
  const double phi = std::atan2(R(2, 0), R(2, 1));
  const double psi = std::atan2(-R(0, 2), R(1, 2));
  return {phi, theta, psi};
//! wrong: quotients, which know no quadrant
  const Matrix3d& R = R_body_from_inertial;
  return {std::atan(R(2, 1) / R(2, 0)), std::acos(R(2, 2)), std::atan(-R(1, 2) / R(0, 2))};
//! wrong: theta from the sine, so never obtuse
  const Matrix3d& R = R_body_from_inertial;
  const double theta = std::asin(std::hypot(R(2, 0), R(2, 1)));
  const double phi = std::atan2(R(2, 1), R(2, 0));
  const Vector3d nodes = R * Vector3d(-std::sin(phi), std::cos(phi), 0);
  return {phi, theta, std::atan2(nodes[0], nodes[1])};
//! wrong: the library's angles, with theta between minus and plus pi
  const Vector3d a = Matrix3d(R_body_from_inertial.transpose()).eulerAngles(2, 1, 2);
  return a;
//! wrong: upside down, the sum of the angles in place of the difference
  const Matrix3d& R = R_body_from_inertial;
  const double theta = std::atan2(std::hypot(R(2, 0), R(2, 1)), R(2, 2));
  if (std::hypot(R(2, 0), R(2, 1)) < 1e-12) return {std::atan2(R(0, 1), R(0, 0)), theta, 0};
  return {std::atan2(R(2, 1), R(2, 0)), theta, std::atan2(R(1, 2), -R(0, 2))};
//! wrong: where the axes coincide both angles come from zeros
-  if (std::hypot(R(2, 0), R(2, 1)) < 1e-12) return {std::atan2(R(0, 1), R(0, 0)), theta, 0};
//! wrong: arc cosine of a number that rounding makes larger than one
  const Matrix3d& R = R_body_from_inertial;
  const double phi = std::atan2(R(2, 1), R(2, 0));
  const Vector3d nodes = R * Vector3d(-std::sin(phi), std::cos(phi), 0);
  return {phi, std::acos(R(2, 2)), std::atan2(nodes[0], nodes[1])};
