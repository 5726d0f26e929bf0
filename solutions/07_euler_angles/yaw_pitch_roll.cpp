#include "rigid/euler_angles.hpp"

#include <cmath>

namespace rigid {

Vector3d yaw_pitch_roll(const Vector3d& angles) {
  const auto about_z = [](double angle) -> Matrix3d {
    return Matrix3d{{std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
  };
  const double theta = angles[1];
  const Matrix3d about_y{{std::cos(theta), 0, -std::sin(theta)}, {0, 1, 0}, {std::sin(theta), 0, std::cos(theta)}};
  const Matrix3d R = about_z(angles[2]) * about_y * about_z(angles[0]);

  // The first row of R is the body axis ê₁ in inertial components: yaw and pitch are its direction.
  const double yaw = std::atan2(R(0, 1), R(0, 0));
  const double pitch = std::atan2(-R(0, 2), std::hypot(R(0, 0), R(0, 1)));
  // The axis of the pitch has the inertial components (−sin yaw, cos yaw, 0) and the body components
  // (0, cos roll, −sin roll). So the roll fits whatever the yaw is, even where ê₁ is vertical and the yaw means
  // nothing.
  const Vector3d pitch_axis = R * Vector3d(-std::sin(yaw), std::cos(yaw), 0);
  return {yaw, pitch, std::atan2(-pitch_axis[2], pitch_axis[1])};
}

}  // namespace rigid
