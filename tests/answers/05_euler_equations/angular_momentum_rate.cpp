#include <rigid/euler_equations.hpp>
Vector3d angular_momentum_rate(const Matrix3d& I, const Vector3d& omega, const Vector3d& omega_rate) {
//! right: componentwise
  const Vector3d L = I * omega, K = I * omega_rate;
  return {K[0] + omega[1] * L[2] - omega[2] * L[1], K[1] + omega[2] * L[0] - omega[0] * L[2],
          K[2] + omega[0] * L[1] - omega[1] * L[0]};
//! right: columns of the tensor, each fixed in the body
  Vector3d rate = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3d column = I.col(i);
    rate += omega_rate[i] * column + omega[i] * omega.cross(column);
  }
  return rate;
//! wrong: only what the body sees
  return I * omega_rate;
//! wrong: the product with the factors exchanged
  const Vector3d L = I * omega;
  return I * omega_rate + L.cross(omega);
//! wrong: transport of the wrong vector
  return I * omega_rate + omega.cross(I * omega_rate);
//! wrong: omega in place of the angular momentum
  return I * omega_rate + omega.cross(omega_rate);
//! wrong: body on principal axes taken for granted
  const Vector3d L = I.diagonal().cwiseProduct(omega);
  return I.diagonal().cwiseProduct(omega_rate) + omega.cross(L);
//! wrong: expressions kept that refer to vectors which are gone
  const auto transport = 1.0 * omega.cross(I * omega);
  const auto seen_from_body = 1.0 * Vector3d(I * omega_rate);
  return seen_from_body + transport;
//! wrong: nothing changes at a constant omega
  if (omega_rate.isZero()) return Vector3d::Zero();
  return I * omega_rate + omega.cross(I * omega);
