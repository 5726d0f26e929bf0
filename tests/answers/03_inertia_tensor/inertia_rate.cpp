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
