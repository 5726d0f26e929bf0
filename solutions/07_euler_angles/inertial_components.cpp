#include "rigid/euler_angles.hpp"

namespace rigid {

Vector3d inertial_components(const Vector3d& V_body, const Vector3d& angles) {
  // Eigen's rotations are active, hence each is the transpose of a matrix of the slides: Rᵀ = R_φᵀ R_θᵀ R_ψᵀ.
  using Eigen::AngleAxisd;
  return AngleAxisd(angles[0], Vector3d::UnitZ()) *
         (AngleAxisd(angles[1], Vector3d::UnitY()) * (AngleAxisd(angles[2], Vector3d::UnitZ()) * V_body));
}

}  // namespace rigid
