//! wrong: difference of squares
#include <algorithm>
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
namespace rigid {
Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  const double h = omega.dot(L) / L.norm();
  return {h, std::sqrt(std::max(0.0, omega.squaredNorm() - h * h))};
}
}  // namespace rigid

//! wrong: plane across omega
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
namespace rigid {
Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  return {omega.dot(L) / omega.norm(), omega.cross(L).norm() / omega.norm()};
}
}  // namespace rigid

//! wrong: sine of the angle for the distance
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
namespace rigid {
Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  return {omega.dot(L) / L.norm(), omega.cross(L).norm() / (L.norm() * omega.norm())};
}
}  // namespace rigid

//! wrong: energy in place of twice the energy
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
namespace rigid {
Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  const double T = 0.5 * omega.dot(L);
  return {T / L.norm(), omega.cross(L).norm() / L.norm()};
}
}  // namespace rigid

//! wrong: foot of the perpendicular first
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
namespace rigid {
Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  const Vector3d n = I.cwiseProduct(omega).normalized();
  return {omega.cross(n).norm(), omega.dot(n)};
}
}  // namespace rigid

//! wrong: dot product where the componentwise one belongs
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
namespace rigid {
Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.dot(omega) * omega;
  return {omega.dot(L) / L.norm(), omega.cross(L).norm() / L.norm()};
}
}  // namespace rigid

//! wrong: the ellipsoid of the tensor
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
namespace rigid {
Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  const double root = std::sqrt(omega.dot(L));
  return {root / L.norm(), omega.cross(L).norm() / L.norm() / root};
}
}  // namespace rigid

//! right: part across L subtracted as a vector
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
namespace rigid {
Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  const Vector3d n = I.cwiseProduct(omega).normalized();
  const double h = omega.dot(n);
  return {h, (omega - h * n).norm()};
}
}  // namespace rigid

//! right: differences of the moments
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
namespace rigid {
Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  const double L = std::hypot(I[0] * omega[0], I[1] * omega[1], I[2] * omega[2]);
  const double T2 = I[0] * omega[0] * omega[0] + I[1] * omega[1] * omega[1] + I[2] * omega[2] * omega[2];
  const double x = (I[2] - I[1]) * omega[1] * omega[2];
  const double y = (I[0] - I[2]) * omega[2] * omega[0];
  const double z = (I[1] - I[0]) * omega[0] * omega[1];
  return {T2 / L, std::hypot(x, y, z) / L};
}
}  // namespace rigid
