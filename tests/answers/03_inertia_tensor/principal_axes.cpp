//! wrong: as the solver returns them, of either handedness
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d principal_axes(const Matrix3d& I) { return Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors(); }
}  // namespace rigid

//! wrong: axes as rows
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d principal_axes(const Matrix3d& I) {
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  return axes.transpose();
}
}  // namespace rigid

//! wrong: descending
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d principal_axes(const Matrix3d& I) {
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors().rowwise().reverse();
  if (axes.determinant() < 0) axes.col(2) *= -1;
  return axes;
}
}  // namespace rigid

//! wrong: left-handed
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d principal_axes(const Matrix3d& I) {
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors();
  axes.col(2) = axes.col(1).cross(axes.col(0));
  return axes;
}
}  // namespace rigid

//! wrong: a diagonal tensor is taken for a sorted one
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d principal_axes(const Matrix3d& I) {
  if (I.isDiagonal()) return Matrix3d::Identity();
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}
}  // namespace rigid

//! wrong: in the order of the general solver
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d principal_axes(const Matrix3d& I) {
  Matrix3d axes = Eigen::EigenSolver<Matrix3d>(I).eigenvectors().real();
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  return axes;
}
}  // namespace rigid

//! wrong: a sphere's axes from an initial guess that is never filled
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d principal_axes(const Matrix3d& I) {
  Matrix3d axes;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
  const Vector3d moments = solver.eigenvalues();
  if (moments[0] != moments[2]) axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  return axes;
}
}  // namespace rigid

//! right: third axis from the two others
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d principal_axes(const Matrix3d& I) {
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}
}  // namespace rigid

//! right: all axes reversed
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d principal_axes(const Matrix3d& I) {
  const Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors();
  return axes.determinant() > 0 ? axes : Matrix3d(-axes);
}
}  // namespace rigid

//! right: singular vectors
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d principal_axes(const Matrix3d& I) {
  const Eigen::JacobiSVD<Matrix3d> svd(I, Eigen::ComputeFullU);
  Matrix3d axes = svd.matrixU().rowwise().reverse();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  return axes;
}
}  // namespace rigid
