//! wrong: order
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  return {L.squaredNorm(), 0.5 * L.dot(omega)};
}
}  // namespace rigid

//! wrong: length in place of the square
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  return Vector2d(0.5 * omega.dot(L), L.norm());
}
}  // namespace rigid

//! wrong: energy without one half
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  return {omega.dot(L), L.dot(L)};
}
}  // namespace rigid

//! wrong: one half in whole numbers
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  double T = 0, L2 = 0;
  for (int i = 0; i < 3; ++i) {
    T += (1 / 2) * I[i] * omega[i] * omega[i];
    L2 += I[i] * I[i] * omega[i] * omega[i];
  }
  return {T, L2};
}
}  // namespace rigid

//! wrong: moments not squared
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  Vector2d result = Vector2d::Zero();
  for (int i = 0; i < 3; ++i) {
    result[0] += 0.5 * I[i] * omega[i] * omega[i];
    result[1] += I[i] * omega[i] * omega[i];
  }
  return result;
}
}  // namespace rigid

//! wrong: square of the sum
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  const double T = 0.5 * I.dot(omega.cwiseAbs2());
  const double L = I.dot(omega);
  return {T, L * L};
}
}  // namespace rigid

//! wrong: the sums are never set
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  Vector2d result;
  for (int i = 0; i < 3; ++i) {
    result[0] += 0.5 * I[i] * omega[i] * omega[i];
    result[1] += I[i] * I[i] * omega[i] * omega[i];
  }
  return result;
}
}  // namespace rigid

//! right: loop
#include <cmath>
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  double T = 0, L2 = 0;
  for (int i = 0; i < 3; ++i) {
    T += I[i] * omega[i] * omega[i] / 2;
    L2 += std::pow(I[i] * omega[i], 2);
  }
  return {T, L2};
}
}  // namespace rigid

//! right: tensor
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  const Matrix3d tensor = I.asDiagonal();
  const Vector3d L = tensor * omega;
  return Vector2d(omega.dot(L) / 2, L.dot(tensor * omega));
}
}  // namespace rigid
