#include <rigid/frame_derivatives.hpp>
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
//! right: componentwise
  return {rate_body[0] + omega[1] * V[2] - omega[2] * V[1], rate_body[1] + omega[2] * V[0] - omega[0] * V[2],
          rate_body[2] + omega[0] * V[1] - omega[1] * V[0]};
//! right: with indices counted round
  Vector3d rate = rate_body;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    rate[i] += omega[j] * V[k] - omega[k] * V[j];
  }
  return rate;
//! right: with the matrix of the product
  Matrix3d W;
  W << 0, -omega.z(), omega.y(), omega.z(), 0, -omega.x(), -omega.y(), omega.x(), 0;
  return rate_body + W * V;
//! wrong: the factors of the product exchanged
  return rate_body + V.cross(omega);
//! wrong: the way back, from the inertial frame to the rotating one
  const Vector3d transport = omega.cross(V);
  return rate_body - transport;
//! wrong: only the transport term
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) { return omega.cross(V); }
//! wrong: product component by component
  return rate_body + omega.cwiseProduct(V);
//! wrong: a vector at rest in the body is taken for one at rest
  if (rate_body.norm() == 0) return Vector3d::Zero();
  return rate_body + omega.cross(V);
//! wrong: arguments in another order
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& V, const Vector3d& omega) {
  return rate_body + omega.cross(V);
}
//! wrong: sign of the middle component
  Vector3d rate = rate_body;
  rate[0] += omega[1] * V[2] - omega[2] * V[1];
  rate[1] += omega[0] * V[2] - omega[2] * V[0];
  rate[2] += omega[0] * V[1] - omega[1] * V[0];
  return rate;
