#include <algorithm>
#include <array>
#include <cmath>
#include <rigid/inertia_tensor.hpp>
Matrix3d principal_axes(const Matrix3d& I) {
//! right: third axis from the two others
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
//! wrong: left-handed
-  axes.col(2) = axes.col(0).cross(axes.col(1));
+  axes.col(2) = axes.col(1).cross(axes.col(0));
//! wrong: a diagonal tensor is taken for a sorted one
 Matrix3d principal_axes(const Matrix3d& I) {
+  if (I.isDiagonal()) return Matrix3d::Identity();
//! right: all axes reversed
  const Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors();
  return axes.determinant() > 0 ? axes : Matrix3d(-axes);
//! right: singular vectors
  const Eigen::JacobiSVD<Matrix3d> svd(I, Eigen::ComputeFullU);
  Matrix3d axes = svd.matrixU().rowwise().reverse();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  return axes;
//! wrong: a sphere's axes from an initial guess that is never filled
-  const Eigen::JacobiSVD<Matrix3d> svd(I, Eigen::ComputeFullU);
-  Matrix3d axes = svd.matrixU().rowwise().reverse();
+  Matrix3d axes;
+  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
+  const Vector3d moments = solver.eigenvalues();
+  if (moments[0] != moments[2]) axes = solver.eigenvectors();
//! wrong: as the solver returns them, of either handedness
Matrix3d principal_axes(const Matrix3d& I) { return Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors(); }
//! wrong: axes as rows
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  return axes.transpose();
//! wrong: descending
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors().rowwise().reverse();
  if (axes.determinant() < 0) axes.col(2) *= -1;
  return axes;
//! wrong: in the order of the general solver
  Matrix3d axes = Eigen::EigenSolver<Matrix3d>(I).eigenvectors().real();
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  return axes;
//! right: rotations of Jacobi
  Matrix3d A = I, V = Matrix3d::Identity();
  for (int sweep = 0; sweep < 60; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (A(p, q) == 0) continue;
        const double th = 0.5 * std::atan2(2 * A(p, q), A(q, q) - A(p, p));
        Matrix3d G = Matrix3d::Identity();
        G(p, p) = G(q, q) = std::cos(th);
        G(p, q) = std::sin(th);
        G(q, p) = -std::sin(th);
        A = (G.transpose() * A * G).eval();
        V = (V * G).eval();
      }
  std::array<int, 3> o{0, 1, 2};
  std::sort(o.begin(), o.end(), [&](int a, int b) { return A(a, a) < A(b, b); });
  Matrix3d U;
  for (int k = 0; k < 3; ++k) U.col(k) = V.col(o[static_cast<std::size_t>(k)]);
  if (U.determinant() < 0) U.col(2) *= -1;
  return U;
