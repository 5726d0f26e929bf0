#include <rigid/euler_equations.hpp>
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
//! right: inverse
  return I.inverse() * (torque - omega.cross(I * omega));
//! wrong: divided component by component
  const Vector3d L = I * omega;
  return (torque - omega.cross(L)).cwiseQuotient(I.diagonal());
//! wrong: the tensor is not inverted
  const Vector3d L = I * omega;
  return I * (torque - omega.cross(L));
//! wrong: the change of the angular momentum, not of omega
  return torque - omega.cross(I * omega);
//! wrong: sign of the gyroscopic term
  return I.inverse() * (torque + omega.cross(I * omega));
//! wrong: the torque is forgotten
  return -I.inverse() * omega.cross(I * omega);
//! wrong: brackets, only the torque is divided
  return I.inverse() * torque - omega.cross(I * omega);
//! right: pivoted elimination
  const Vector3d right_side = torque + (I * omega).cross(omega);
  return I.fullPivLu().solve(right_side);
//! right: on the principal axes, and back
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
  const Matrix3d A = solver.eigenvectors();
  const Vector3d moments = solver.eigenvalues();
  const Vector3d right_side = A.transpose() * (torque - omega.cross(I * omega));
  return A * right_side.cwiseQuotient(moments);
//! wrong: the principal moments in the order of the solver, on the old axes
  const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvalues();
  const Vector3d L = moments.cwiseProduct(omega);
  return (torque - omega.cross(L)).cwiseQuotient(moments);
//! wrong: the shortcut for principal axes has another sign
  const Vector3d L = I * omega;
  if (I.isDiagonal()) return (torque + omega.cross(L)).cwiseQuotient(I.diagonal());
  return I.inverse() * (torque - omega.cross(L));
