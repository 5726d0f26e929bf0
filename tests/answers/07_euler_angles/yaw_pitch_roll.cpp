#include <cmath>
#include <rigid/euler_angles.hpp>
Vector3d yaw_pitch_roll(const Vector3d& angles) {
//! wrong: pitch from the arc cosine, never negative
  const double cf = std::cos(angles[0]), sf = std::sin(angles[0]), ct = std::cos(angles[1]), st = std::sin(angles[1]);
  const double cp = std::cos(angles[2]), sp = std::sin(angles[2]);
  const Vector3d x(cf * ct * cp - sf * sp, sf * ct * cp + cf * sp, -st * cp);
  const Vector3d y(-cf * ct * sp - sf * cp, -sf * ct * sp + cf * cp, st * sp), z(cf * st, sf * st, ct);
  return {std::atan2(x[1], x[0]), std::acos(std::hypot(x[0], x[1])), std::atan2(y[2], z[2])};
//! right: pitch from its sine and cosine
-  return {std::atan2(x[1], x[0]), std::acos(std::hypot(x[0], x[1])), std::atan2(y[2], z[2])};
+  return {std::atan2(x[1], x[0]), std::atan2(-x[2], std::hypot(x[0], x[1])), std::atan2(y[2], z[2])};
//! wrong: the library's angles, whose pitch goes beyond a right angle
  const Matrix3d A = (Eigen::AngleAxisd(angles[0], Vector3d::UnitZ()) * Eigen::AngleAxisd(angles[1], Vector3d::UnitY()) *
                      Eigen::AngleAxisd(angles[2], Vector3d::UnitZ())).toRotationMatrix();
  return A.eulerAngles(2, 1, 0);
