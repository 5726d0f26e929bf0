#include <rigid/euler_equations.hpp>
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
//! right: three equations
  return {(torque[0] - omega[1] * omega[2] * (I[2] - I[1])) / I[0],
          (torque[1] - omega[2] * omega[0] * (I[0] - I[2])) / I[1],
          (torque[2] - omega[0] * omega[1] * (I[1] - I[0])) / I[2]};
//! wrong: the second equation not cyclic
-          (torque[1] - omega[2] * omega[0] * (I[0] - I[2])) / I[1],
+          (torque[1] - omega[2] * omega[0] * (I[2] - I[0])) / I[1],
//! right: with the tensor and its inverse
  const Matrix3d tensor = I.asDiagonal();
  const Vector3d L = tensor * omega;
  return tensor.inverse() * (torque + L.cross(omega));
//! wrong: sign of the differences
  return {(torque[0] + omega[1] * omega[2] * (I[2] - I[1])) / I[0],
          (torque[1] + omega[2] * omega[0] * (I[0] - I[2])) / I[1],
          (torque[2] + omega[0] * omega[1] * (I[1] - I[0])) / I[2]};
//! wrong: not divided by the moments
  const Vector3d L = I.cwiseProduct(omega);
  return torque - omega.cross(L);
//! wrong: the torque is forgotten
  const Vector3d L = I.cwiseProduct(omega);
  return -omega.cross(L).cwiseQuotient(I);
//! wrong: only the torque is divided
  const Vector3d L = I.cwiseProduct(omega);
  return torque.cwiseQuotient(I) - omega.cross(L);
//! wrong: sign of the gyroscopic terms, and the torque not divided by the moment
  Vector3d rate;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    rate[i] = torque[i] + (I[k] - I[j]) / I[i] * omega[j] * omega[k];
  }
  return rate;
//! wrong: a symmetric top is taken to be free of torque along its axis
-    rate[i] = torque[i] + (I[k] - I[j]) / I[i] * omega[j] * omega[k];
+    rate[i] = I[j] == I[k] ? 0.0 : (torque[i] - omega[j] * omega[k] * (I[k] - I[j])) / I[i];
//! wrong: differences of the moments in whole numbers
-    rate[i] = torque[i] + (I[k] - I[j]) / I[i] * omega[j] * omega[k];
+    const int difference = I[k] - I[j];
+    rate[i] = (torque[i] - omega[j] * omega[k] * difference) / I[i];
