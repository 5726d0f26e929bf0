//! wrong: the factors of the product exchanged
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  return rate_body + V.cross(omega);
}
}  // namespace rigid

//! wrong: the way back, from the inertial frame to the rotating one
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  const Vector3d transport = omega.cross(V);
  return rate_body - transport;
}
}  // namespace rigid

//! wrong: only the transport term
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) { return omega.cross(V); }
}  // namespace rigid

//! wrong: product component by component
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  return rate_body + omega.cwiseProduct(V);
}
}  // namespace rigid

//! wrong: a vector at rest in the body is taken for one at rest
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  if (rate_body.norm() == 0) return Vector3d::Zero();
  return rate_body + omega.cross(V);
}
}  // namespace rigid

//! wrong: arguments in another order
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& V, const Vector3d& omega) {
  return rate_body + omega.cross(V);
}
}  // namespace rigid

//! wrong: sign of the middle component
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  Vector3d rate = rate_body;
  rate[0] += omega[1] * V[2] - omega[2] * V[1];
  rate[1] += omega[0] * V[2] - omega[2] * V[0];
  rate[2] += omega[0] * V[1] - omega[1] * V[0];
  return rate;
}
}  // namespace rigid

//! right: componentwise
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  return {rate_body[0] + omega[1] * V[2] - omega[2] * V[1], rate_body[1] + omega[2] * V[0] - omega[0] * V[2],
          rate_body[2] + omega[0] * V[1] - omega[1] * V[0]};
}
}  // namespace rigid

//! right: with indices counted round
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  Vector3d rate = rate_body;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    rate[i] += omega[j] * V[k] - omega[k] * V[j];
  }
  return rate;
}
}  // namespace rigid

//! right: with the matrix of the product
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  Matrix3d W;
  W << 0, -omega.z(), omega.y(), omega.z(), 0, -omega.x(), -omega.y(), omega.x(), 0;
  return rate_body + W * V;
}
}  // namespace rigid
