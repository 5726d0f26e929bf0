#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/free_tops.hpp>
Vector2d flat_spin(const Vector3d& I, const Vector3d& omega) {
//! right: L is kept, the energy sinks to that about the largest moment
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.maxCoeff();
  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), L.norm() / i};
//! wrong: smallest moment
-  const double i = I.maxCoeff();
+  const double i = I.minCoeff();
//! wrong: third moment
-  const double i = I.maxCoeff();
+  const double i = I[2];
//! wrong: energy without the half
-  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), L.norm() / i};
+  return {L.dot(omega) - L.squaredNorm() / i, L.norm() / i};
//! wrong: final energy, not the loss
-  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), L.norm() / i};
+  return {L.squaredNorm() / (2 * i), L.norm() / i};
//! wrong: rate kept
-  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), L.norm() / i};
+  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), omega.norm()};
//! wrong: order of the results
-  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), L.norm() / i};
+  return {L.norm() / i, 0.5 * L.dot(omega) - L.squaredNorm() / (2 * i)};
//! wrong: the component about the axis of the largest moment kept
  int k;
  I.maxCoeff(&k);
  const double T = 0.5 * I.dot(omega.cwiseAbs2());
  const double rate = std::abs(omega[k]);
  return {T - 0.5 * I[k] * rate * rate, rate};
//! right: heat by differences of moments
  const double top = I.maxCoeff();
  const Vector3d L = I.cwiseProduct(omega);
  double heat = 0;
  for (int i = 0; i < 3; ++i) heat += 0.5 * omega[i] * omega[i] * I[i] * (top - I[i]) / top;
  return {heat, L.norm() / top};
