#include <algorithm>
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
//! right: part across L subtracted as a vector
  const Vector3d n = I.cwiseProduct(omega).normalized();
  const double h = omega.dot(n);
  return {h, (omega - h * n).norm()};
//! wrong: foot of the perpendicular first
  const Vector3d n = I.cwiseProduct(omega).normalized();
  return {omega.cross(n).norm(), omega.dot(n)};
//! right: differences of the moments
  const double L = std::hypot(I[0] * omega[0], I[1] * omega[1], I[2] * omega[2]);
  const double T2 = I[0] * omega[0] * omega[0] + I[1] * omega[1] * omega[1] + I[2] * omega[2] * omega[2];
  const double x = (I[2] - I[1]) * omega[1] * omega[2];
  const double y = (I[0] - I[2]) * omega[2] * omega[0];
  const double z = (I[1] - I[0]) * omega[0] * omega[1];
  return {T2 / L, std::hypot(x, y, z) / L};
//! wrong: plane across omega
  const Vector3d L = I.cwiseProduct(omega);
  return {omega.dot(L) / omega.norm(), omega.cross(L).norm() / omega.norm()};
//! wrong: sine of the angle for the distance
  const Vector3d L = I.cwiseProduct(omega);
  return {omega.dot(L) / L.norm(), omega.cross(L).norm() / (L.norm() * omega.norm())};
//! wrong: energy in place of twice the energy
  const Vector3d L = I.cwiseProduct(omega);
  const double T = 0.5 * omega.dot(L);
  return {T / L.norm(), omega.cross(L).norm() / L.norm()};
//! wrong: dot product where the componentwise one belongs
  const Vector3d L = I.dot(omega) * omega;
  return {omega.dot(L) / L.norm(), omega.cross(L).norm() / L.norm()};
//! wrong: the ellipsoid of the tensor
  const Vector3d L = I.cwiseProduct(omega);
  const double root = std::sqrt(omega.dot(L));
  return {root / L.norm(), omega.cross(L).norm() / L.norm() / root};
//! wrong: foot of the perpendicular on omega
  const Vector3d L = I.cwiseProduct(omega);
  return {omega.dot(L) / omega.norm(), omega.cross(L).norm() / omega.norm()};
//! wrong: a difference of squares
  const Vector3d L = I.cwiseProduct(omega);
  const double h = omega.dot(L.normalized());
  return {h, std::sqrt(std::max(0.0, omega.squaredNorm() - h * h))};
