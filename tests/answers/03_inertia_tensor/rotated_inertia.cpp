#include <rigid/inertia_tensor.hpp>
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
//! right: four indices
  const Matrix3d& A = A_inertial_from_body;
  Matrix3d I = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) I(i, j) += A(i, k) * A(j, l) * I_body(k, l);
  return I;
//! wrong: one index of the sum mixed up
-        for (int l = 0; l < 3; ++l) I(i, j) += A(i, k) * A(j, l) * I_body(k, l);
+        for (int l = 0; l < 3; ++l) I(i, j) += A(i, k) * I_body(k, l) * A(l, j);
//! right: the inverse of the rotation
  return A_inertial_from_body * I_body * A_inertial_from_body.inverse();
//! wrong: transposed
  const Matrix3d& A = A_inertial_from_body;
  return A.transpose() * I_body * A;
//! wrong: as if a tensor were a vector
  return A_inertial_from_body * I_body;
//! wrong: the rotation twice
  return A_inertial_from_body * I_body * A_inertial_from_body;
//! wrong: only the diagonal
  return A_inertial_from_body * I_body.diagonal().asDiagonal() * A_inertial_from_body.transpose();
//! right: principal axes, rotated
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I_body);
  Matrix3d I = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3d e = A_inertial_from_body * solver.eigenvectors().col(i);
    I += solver.eigenvalues()[i] * e * e.transpose();
  }
  return I;
//! wrong: a product written over its own factor
  Matrix3d I = I_body;
  I.noalias() = A_inertial_from_body * I;
  I.noalias() = I * A_inertial_from_body.transpose();
  return I;
//! wrong: indices of the first factor exchanged
  Matrix3d J = Matrix3d::Zero();
  const Matrix3d& A = A_inertial_from_body;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) J(i, j) += A(k, i) * I_body(k, l) * A(j, l);
  return J;
