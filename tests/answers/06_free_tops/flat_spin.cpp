#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/free_tops.hpp>
Vector2d flat_spin(const Vector3d& I, const Vector3d& omega) {
//! wrong: smallest moment
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.minCoeff();
  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), L.norm() / i};
//! wrong: third moment
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I[2];
  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), L.norm() / i};
//! wrong: energy without the half
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.maxCoeff();
  return {L.dot(omega) - L.squaredNorm() / i, L.norm() / i};
//! wrong: final energy, not the loss
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.maxCoeff();
  return {L.squaredNorm() / (2 * i), L.norm() / i};
//! wrong: rate kept
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.maxCoeff();
  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), omega.norm()};
//! wrong: order of the results
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.maxCoeff();
  return {L.norm() / i, 0.5 * L.dot(omega) - L.squaredNorm() / (2 * i)};
