#include <rigid/euler_equations.hpp>
Vector3d torque_to_hold_rotation(const Matrix3d& I, const Vector3d& omega) {
//! right: componentwise
  const Vector3d L = I * omega;
  return {omega.y() * L.z() - omega.z() * L.y(), omega.z() * L.x() - omega.x() * L.z(),
          omega.x() * L.y() - omega.y() * L.x()};
//! wrong: factors exchanged
  const Vector3d L = I * omega;
  return L.cross(omega);
//! right: on the principal axes, and back
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
  const Matrix3d A = solver.eigenvectors();
  const Vector3d m = solver.eigenvalues(), w = A.transpose() * omega;
  return A.col(0).cross(A.col(1)).dot(A.col(2)) * A *
         Vector3d((m[2] - m[1]) * w[1] * w[2], (m[0] - m[2]) * w[2] * w[0], (m[1] - m[0]) * w[0] * w[1]);
//! wrong: nothing is needed for a constant omega
Vector3d torque_to_hold_rotation(const Matrix3d& I, const Vector3d& omega) { return Vector3d::Zero(); }
//! wrong: the angular momentum itself
Vector3d torque_to_hold_rotation(const Matrix3d& I, const Vector3d& omega) { return I * omega; }
//! wrong: divided by the moments, an acceleration
  return I.inverse() * omega.cross(I * omega);
//! wrong: formula of the principal axes with the diagonal
  return {(I(2, 2) - I(1, 1)) * omega[1] * omega[2], (I(0, 0) - I(2, 2)) * omega[2] * omega[0],
          (I(1, 1) - I(0, 0)) * omega[0] * omega[1]};
//! wrong: product with omega afterwards
Vector3d torque_to_hold_rotation(const Matrix3d& I, const Vector3d& omega) { return I * omega.cross(omega); }
//! wrong: no torque on principal axes
  if (I.isDiagonal()) return Vector3d::Zero();
  return omega.cross(I * omega);
