#include "rigid/euler_equations.hpp"

namespace rigid {

Matrix3d reorientation(const Matrix3d& I, const Vector2d& J, const VectorXd& wheel1, const VectorXd& wheel2) {
  const Eigen::LDLT<Matrix3d> inertia(I);
  Matrix3d A = Matrix3d::Identity();
  for (Eigen::Index k = 1; k < wheel1.size(); ++k) {
    // I ω + J α̇ = 0 on the axes of the body, and so the same with angles: ω keeps its direction between two corners.
    const Vector3d of_wheels(J[0] * (wheel1[k] - wheel1[k - 1]), J[1] * (wheel2[k] - wheel2[k - 1]), 0);
    const Vector3d turned = -inertia.solve(of_wheels);
    A = A * Eigen::AngleAxisd(turned.norm(), turned.stableNormalized());  // about an axis of the body
  }
  return A;
}

}  // namespace rigid
