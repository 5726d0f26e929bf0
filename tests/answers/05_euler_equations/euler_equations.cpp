//! wrong: sign of the differences
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  return {(torque[0] + omega[1] * omega[2] * (I[2] - I[1])) / I[0],
          (torque[1] + omega[2] * omega[0] * (I[0] - I[2])) / I[1],
          (torque[2] + omega[0] * omega[1] * (I[1] - I[0])) / I[2]};
}
}  // namespace rigid

//! wrong: not divided by the moments
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Vector3d L = I.cwiseProduct(omega);
  return torque - omega.cross(L);
}
}  // namespace rigid

//! wrong: the second equation not cyclic
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  return {(torque[0] - omega[1] * omega[2] * (I[2] - I[1])) / I[0],
          (torque[1] - omega[2] * omega[0] * (I[2] - I[0])) / I[1],
          (torque[2] - omega[0] * omega[1] * (I[1] - I[0])) / I[2]};
}
}  // namespace rigid

//! wrong: the torque is forgotten
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Vector3d L = I.cwiseProduct(omega);
  return -omega.cross(L).cwiseQuotient(I);
}
}  // namespace rigid

//! wrong: only the torque is divided
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Vector3d L = I.cwiseProduct(omega);
  return torque.cwiseQuotient(I) - omega.cross(L);
}
}  // namespace rigid

//! wrong: a symmetric top is taken to be free of torque along its axis
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  Vector3d rate;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    rate[i] = I[j] == I[k] ? 0.0 : (torque[i] - omega[j] * omega[k] * (I[k] - I[j])) / I[i];
  }
  return rate;
}
}  // namespace rigid

//! wrong: differences of the moments in whole numbers
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  Vector3d rate;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const int difference = I[k] - I[j];
    rate[i] = (torque[i] - omega[j] * omega[k] * difference) / I[i];
  }
  return rate;
}
}  // namespace rigid

//! right: three equations
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  return {(torque[0] - omega[1] * omega[2] * (I[2] - I[1])) / I[0],
          (torque[1] - omega[2] * omega[0] * (I[0] - I[2])) / I[1],
          (torque[2] - omega[0] * omega[1] * (I[1] - I[0])) / I[2]};
}
}  // namespace rigid

//! right: with the tensor and its inverse
#include <rigid/euler_equations.hpp>
namespace rigid {
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Matrix3d tensor = I.asDiagonal();
  const Vector3d L = tensor * omega;
  return tensor.inverse() * (torque + L.cross(omega));
}
}  // namespace rigid
