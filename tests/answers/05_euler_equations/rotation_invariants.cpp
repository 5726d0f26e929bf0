#include <cmath>
#include <rigid/euler_equations.hpp>
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
//! right: loop
  double T = 0, L2 = 0;
  for (int i = 0; i < 3; ++i) {
    T += I[i] * omega[i] * omega[i] / 2;
    L2 += std::pow(I[i] * omega[i], 2);
  }
  return {T, L2};
//! wrong: one half in whole numbers
-    T += I[i] * omega[i] * omega[i] / 2;
-    L2 += std::pow(I[i] * omega[i], 2);
+    T += (1 / 2) * I[i] * omega[i] * omega[i];
+    L2 += I[i] * I[i] * omega[i] * omega[i];
//! right: tensor
  const Matrix3d tensor = I.asDiagonal();
  const Vector3d L = tensor * omega;
  return Vector2d(omega.dot(L) / 2, L.dot(tensor * omega));
//! wrong: order
  const Vector3d L = I.cwiseProduct(omega);
  return {L.squaredNorm(), 0.5 * L.dot(omega)};
//! wrong: length in place of the square
  const Vector3d L = I.cwiseProduct(omega);
  return Vector2d(0.5 * omega.dot(L), L.norm());
//! wrong: energy without one half
  const Vector3d L = I.cwiseProduct(omega);
  return {omega.dot(L), L.dot(L)};
//! wrong: moments not squared
  Vector2d result = Vector2d::Zero();
  for (int i = 0; i < 3; ++i) {
    result[0] += 0.5 * I[i] * omega[i] * omega[i];
    result[1] += I[i] * omega[i] * omega[i];
  }
  return result;
//! wrong: square of the sum
  const double T = 0.5 * I.dot(omega.cwiseAbs2());
  const double L = I.dot(omega);
  return {T, L * L};
//! wrong: the sums are never set
  Vector2d result;
  for (int i = 0; i < 3; ++i) {
    result[0] += 0.5 * I[i] * omega[i] * omega[i];
    result[1] += I[i] * I[i] * omega[i] * omega[i];
  }
  return result;
