#include "rigid/frame_derivatives.hpp"

namespace rigid {

Vector3d angular_velocity_of_basis(const Matrix3d& E, const Matrix3d& E_rate) {
  Vector3d sum = Vector3d::Zero();
  // e × (ω × e) is the part of ω perpendicular to e; of three perpendicular parts each component is counted twice.
  for (int i = 0; i < 3; ++i) sum += E.col(i).cross(E_rate.col(i));
  return sum / 2;
}

}  // namespace rigid
