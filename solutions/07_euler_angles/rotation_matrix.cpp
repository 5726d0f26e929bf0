#include "rigid/euler_angles.hpp"

#include <cmath>

namespace rigid {

Matrix3d rotation_matrix(const Vector3d& angles) {
  const double phi = angles[0], theta = angles[1], psi = angles[2];
  // Passive turns: the components of a vector at rest on axes that turn.
  const auto about_z = [](double angle) -> Matrix3d {
    return Matrix3d{{std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
  };
  const Matrix3d about_y{{std::cos(theta), 0, -std::sin(theta)}, {0, 1, 0}, {std::sin(theta), 0, std::cos(theta)}};
  return about_z(psi) * about_y * about_z(phi);  // what turns first stands on the right
}

}  // namespace rigid
