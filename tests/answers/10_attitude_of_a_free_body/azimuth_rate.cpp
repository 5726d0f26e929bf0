#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
double azimuth_rate(const Vector3d& I, const Vector3d& omega) {
//! right: sums of squares by hand
  const double a = I[0] * omega[0], b = I[1] * omega[1], c = I[2] * omega[2];
  return std::sqrt(a * a + b * b + c * c) * (a * omega[0] + b * omega[1]) / (a * a + b * b);
//! right: by the velocity of the tip
  const Vector3d up = I.cwiseProduct(omega).normalized(), tip = Vector3d::UnitZ();
  const Vector3d round = up.cross(tip);
  return omega.cross(tip).dot(round) / round.dot(round);
//! wrong: the formula of the contract as it stands
  const Vector3d L = I.cwiseProduct(omega);
  const double c = L[2] / L.norm();
  return (omega.dot(L) / L.norm() - omega[2] * c) / (1 - c * c);
//! wrong: sine of the angle with omega
-  const double c = L[2] / L.norm();
+  const double c = omega[2] / omega.norm();
//! wrong: the angle from ω in place of that from L
-  const double c = L[2] / L.norm();
+  const double c = omega[2] / omega.norm();
//! wrong: mean of two rates
  const double L = I.cwiseProduct(omega).norm();
  return L * (1 / I[0] + 1 / I[1]) / 2;
//! wrong: moments not squared below
  const Vector3d L = I.cwiseProduct(omega);
  return L.norm() * (L[0] * omega[0] + L[1] * omega[1]) / (I[0] * omega[0] * omega[0] + I[1] * omega[1] * omega[1]);
//! wrong: all terms of the energy above
  const Vector3d L = I.cwiseProduct(omega);
  return L.norm() * omega.dot(L) / (L[0] * L[0] + L[1] * L[1]);
//! wrong: the length of L over the third moment
  const Vector3d L = I.cwiseProduct(omega);
  const double c = L[2] / L.norm(), s2 = 1 - c * c;
  return (L.norm() / I[2]) * (1 - c * c) / s2;
