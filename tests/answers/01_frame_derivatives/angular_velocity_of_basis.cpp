#include <rigid/frame_derivatives.hpp>
Vector3d angular_velocity_of_basis(const Matrix3d& E, const Matrix3d& E_rate) {
//! right: read off the matrix
  const Matrix3d W = E_rate * E.transpose();
  return Vector3d(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1)) / 2;
//! wrong: rows and columns of the antisymmetric matrix mixed up
  const Matrix3d W = E_rate * E.transpose();
  return Vector3d(W(1, 2), W(2, 0), W(0, 1));
//! right: components on the basis, each from one rate
  const Vector3d e1 = E.col(0), e2 = E.col(1), e3 = E.col(2);
  return E_rate.col(1).dot(e3) * e1 + E_rate.col(2).dot(e1) * e2 + E_rate.col(0).dot(e2) * e3;
//! right: the body components, then taken to the inertial axes
  const Matrix3d W = E.transpose() * E_rate;
  const Vector3d omega_body(W(2, 1), W(0, 2), W(1, 0));
  return E * omega_body;
//! wrong: body components, from the transposed product
  const Matrix3d W = E.transpose() * E_rate;
  return {W(2, 1), W(0, 2), W(1, 0)};
//! wrong: the sum counts every component twice
  Vector3d omega = Vector3d::Zero();
  for (int i = 0; i < 3; i++) omega += E.col(i).cross(E_rate.col(i));
  return omega;
//! wrong: one half in whole numbers
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) sum += E.col(i).cross(E_rate.col(i));
  return 1 / 2 * sum;
//! wrong: right only where the basis is the inertial one
  return {E_rate(2, 1), E_rate(0, 2), E_rate(1, 0)};
//! wrong: the sum is never set to zero
  Vector3d omega;
  for (int i = 0; i < 3; ++i) omega += 0.5 * E.col(i).cross(E_rate.col(i));
  return omega;
