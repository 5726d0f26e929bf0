#include <algorithm>
#include <cmath>
#include <rigid/inertia_tensor.hpp>
Vector3d principal_moments(const Matrix3d& I) {
//! right: singular values, which are the moments because none is negative
  const Eigen::JacobiSVD<Matrix3d> svd(I);
  return svd.singularValues().reverse();
//! right: general solver, then sorted
  Vector3d moments = Eigen::EigenSolver<Matrix3d>(I).eigenvalues().real();
  std::sort(moments.data(), moments.data() + 3);
  return moments;
//! wrong: the diagonal
-  Vector3d moments = Eigen::EigenSolver<Matrix3d>(I).eigenvalues().real();
+  Vector3d moments = I.diagonal();
//! wrong: only the product of inertia of x and y is seen
  const double mean = (I(0, 0) + I(1, 1)) / 2, half = (I(0, 0) - I(1, 1)) / 2;
  const double root = std::sqrt(half * half + I(0, 1) * I(0, 1));
  Vector3d moments(mean - root, mean + root, I(2, 2));
  std::sort(moments.data(), moments.data() + 3);
  return moments;
//! right: Jacobi rotations
  Matrix3d D = I;
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (D(p, q) == 0) continue;
        const double angle = 0.5 * std::atan2(2 * D(p, q), D(q, q) - D(p, p));
        Matrix3d J = Matrix3d::Identity();
        J(p, p) = J(q, q) = std::cos(angle);
        J(p, q) = std::sin(angle);
        J(q, p) = -std::sin(angle);
        D = (J.transpose() * D * J).eval();
      }
    }
  }
  Vector3d moments = D.diagonal();
  std::sort(moments.data(), moments.data() + 3);
  return moments;
//! wrong: descending
  const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvalues();
  return moments.reverse();
//! wrong: in the order of the general solver
Vector3d principal_moments(const Matrix3d& I) { return Eigen::EigenSolver<Matrix3d>(I).eigenvalues().real(); }
//! wrong: squares, from the singular values of the square
  const Matrix3d square = I * I;
  Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(square).eigenvalues();
  return moments;
//! wrong: single precision
  const Eigen::Matrix3f single = I.cast<float>();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(single).eigenvalues().cast<double>();
//! right: singular values in reverse order
  const Eigen::JacobiSVD<Matrix3d> svd(I);
  return svd.singularValues().reverse();
