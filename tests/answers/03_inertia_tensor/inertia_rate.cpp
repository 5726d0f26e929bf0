#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/inertia_tensor.hpp>
Matrix3d inertia_rate(const Matrix3d& I, const Vector3d& omega) {
//! right: by the commutator
  Matrix3d W;
  W << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
  return W * I - I * W;
//! wrong: half of it
-  return W * I - I * W;
+  return 0.5 * (W * I - I * W);
//! wrong: one sign in the matrix
-  W << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
+  W << 0, -omega[2], omega[1], omega[2], 0, omega[0], -omega[1], omega[0], 0;
//! wrong: triple product
-  return W * I - I * W;
+  return W * I * W;
//! wrong: angular momentum rate on the diagonal
  const Vector3d d = omega.cross(I * omega);
  return d.asDiagonal();
//! right: difference quotients of rotated tensors, extrapolated
  const double w = omega.norm();
  if (w == 0) return Matrix3d::Zero();
  const auto at = [&](double t) {
    const Matrix3d A = Eigen::AngleAxisd(w * t, omega / w).toRotationMatrix();
    return Matrix3d(A * I * A.transpose());
  };
  const double h = 2e-2 / w;
  const auto d = [&](double s) { return Matrix3d((at(s) - at(-s)) / (2 * s)); };
  const Matrix3d a = d(h), b = d(h / 2), c = d(h / 4), e = d(h / 8);
  const Matrix3d p = (4 * b - a) / 3, q = (4 * c - b) / 3, r = (4 * e - c) / 3;
  const Matrix3d x = (16 * q - p) / 15, y = (16 * r - q) / 15;
  return (64 * y - x) / 63;
//! wrong: forward difference of a rotation to first order
  Matrix3d W;
  W << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
  const double h = 1e-4;
  const Matrix3d A = Matrix3d::Identity() + h * W;
  return (A * I * A.transpose() - I) / h;
