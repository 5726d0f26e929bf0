#include "rigid/euler_angles.hpp"

#include <cmath>

namespace rigid {

double angle_between_attitudes(const Vector3d& angles1, const Vector3d& angles2) {
  const auto attitude = [](const Vector3d& q) -> Matrix3d {
    return (Eigen::AngleAxisd(q[0], Vector3d::UnitZ()) * Eigen::AngleAxisd(q[1], Vector3d::UnitY()) *
            Eigen::AngleAxisd(q[2], Vector3d::UnitZ()))
        .toRotationMatrix();
  };
  const Matrix3d D = attitude(angles2) * attitude(angles1).transpose();  // from the first attitude to the second
  // D = 1 + sin α [n] + (1 − cos α) [n]²: the sine is accurate near 0 and π, the cosine between.
  const Vector3d twice_sine(D(2, 1) - D(1, 2), D(0, 2) - D(2, 0), D(1, 0) - D(0, 1));
  return std::atan2(twice_sine.norm(), D.trace() - 1);
}

}  // namespace rigid
