#include <rigid/inertia_tensor.hpp>
Vector3d angular_momentum(const Matrix3d& I, const Vector3d& omega) {
//! right: loops
  Vector3d L = Vector3d::Zero();
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) L[i] += I(i, j) * omega[j];
  return L;
//! wrong: the last column is left out of the sum
-    for (int j = 0; j < 3; j++) L[i] += I(i, j) * omega[j];
+    for (int j = 0; j < 2; j++) L[i] += I(i, j) * omega[j];
//! right: columns
  return omega.x() * I.col(0) + omega.y() * I.col(1) + omega.z() * I.col(2);
//! wrong: along omega, with the moment about that axis
  if (omega.norm() == 0) return Vector3d::Zero();
  const Vector3d n = omega.normalized();
  return n.dot(I * n) * omega;
//! wrong: only the diagonal
Vector3d angular_momentum(const Matrix3d& I, const Vector3d& omega) { return I.diagonal().cwiseProduct(omega); }
//! wrong: one half as in the energy
Vector3d angular_momentum(const Matrix3d& I, const Vector3d& omega) { return 0.5 * I * omega; }
//! wrong: products of inertia with the other sign
  Vector3d L;
  L[0] = I(0, 0) * omega[0] - I(0, 1) * omega[1] - I(0, 2) * omega[2];
  L[1] = -I(1, 0) * omega[0] + I(1, 1) * omega[1] - I(1, 2) * omega[2];
  L[2] = -I(2, 0) * omega[0] - I(2, 1) * omega[1] + I(2, 2) * omega[2];
  return L;
//! wrong: the sum starts anywhere
  Vector3d L;
  for (int i = 0; i < 3; i++) {
    double sum;
    for (int j = 0; j < 3; j++) sum += I(i, j) * omega[j];
    L[i] = sum;
  }
  return L;
