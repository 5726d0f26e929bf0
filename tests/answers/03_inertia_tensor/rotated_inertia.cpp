//! wrong: transposed
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  const Matrix3d& A = A_inertial_from_body;
  return A.transpose() * I_body * A;
}
}  // namespace rigid

//! wrong: as if a tensor were a vector
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  return A_inertial_from_body * I_body;
}
}  // namespace rigid

//! wrong: the rotation twice
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  return A_inertial_from_body * I_body * A_inertial_from_body;
}
}  // namespace rigid

//! wrong: only the diagonal
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  return A_inertial_from_body * I_body.diagonal().asDiagonal() * A_inertial_from_body.transpose();
}
}  // namespace rigid

//! wrong: a product written over its own factor
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  Matrix3d I = I_body;
  I.noalias() = A_inertial_from_body * I;
  I.noalias() = I * A_inertial_from_body.transpose();
  return I;
}
}  // namespace rigid

//! wrong: one index of the sum mixed up
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  const Matrix3d& A = A_inertial_from_body;
  Matrix3d I = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) I(i, j) += A(i, k) * I_body(k, l) * A(l, j);
  return I;
}
}  // namespace rigid

//! right: four indices
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  const Matrix3d& A = A_inertial_from_body;
  Matrix3d I = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) I(i, j) += A(i, k) * A(j, l) * I_body(k, l);
  return I;
}
}  // namespace rigid

//! right: the inverse of the rotation
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  return A_inertial_from_body * I_body * A_inertial_from_body.inverse();
}
}  // namespace rigid

//! right: principal axes, rotated
#include <rigid/inertia_tensor.hpp>
namespace rigid {
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I_body);
  Matrix3d I = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3d e = A_inertial_from_body * solver.eigenvectors().col(i);
    I += solver.eigenvalues()[i] * e * e.transpose();
  }
  return I;
}
}  // namespace rigid
