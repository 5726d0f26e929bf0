//! wrong: divided component by component
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Vector3d L = I * omega;
  return (torque - omega.cross(L)).cwiseQuotient(I.diagonal());
}
}  // namespace rigid

//! wrong: the tensor is not inverted
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Vector3d L = I * omega;
  return I * (torque - omega.cross(L));
}
}  // namespace rigid

//! wrong: the change of the angular momentum, not of omega
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  return torque - omega.cross(I * omega);
}
}  // namespace rigid

//! wrong: sign of the gyroscopic term
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  return I.inverse() * (torque + omega.cross(I * omega));
}
}  // namespace rigid

//! wrong: the torque is forgotten
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  return -I.inverse() * omega.cross(I * omega);
}
}  // namespace rigid

//! wrong: brackets, only the torque is divided
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  return I.inverse() * torque - omega.cross(I * omega);
}
}  // namespace rigid

//! wrong: the principal moments in the order of the solver, on the old axes
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvalues();
  const Vector3d L = moments.cwiseProduct(omega);
  return (torque - omega.cross(L)).cwiseQuotient(moments);
}
}  // namespace rigid

//! wrong: the shortcut for principal axes has another sign
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Vector3d L = I * omega;
  if (I.isDiagonal()) return (torque + omega.cross(L)).cwiseQuotient(I.diagonal());
  return I.inverse() * (torque - omega.cross(L));
}
}  // namespace rigid

//! right: inverse
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  return I.inverse() * (torque - omega.cross(I * omega));
}
}  // namespace rigid

//! right: pivoted elimination
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Vector3d right_side = torque + (I * omega).cross(omega);
  return I.fullPivLu().solve(right_side);
}
}  // namespace rigid

//! right: on the principal axes, and back
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
  const Matrix3d A = solver.eigenvectors();
  const Vector3d moments = solver.eigenvalues();
  const Vector3d right_side = A.transpose() * (torque - omega.cross(I * omega));
  return A * right_side.cwiseQuotient(moments);
}
}  // namespace rigid
