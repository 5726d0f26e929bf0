#include "rigid/frame_derivatives.hpp"

namespace rigid {

Matrix3d rotated_basis(const Matrix3d& E, const Vector3d& omega, double dt) {
  // stableNormalized() leaves the zero vector as it is, and turning about it by the angle 0 turns nothing.
  const Eigen::AngleAxisd turn(omega.stableNorm() * dt, omega.stableNormalized());
  // From the left, because omega has inertial components like the columns of E.
  return turn.toRotationMatrix() * E;
}

}  // namespace rigid
