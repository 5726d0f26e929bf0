//! wrong: subscripts exchanged
#include <rigid/free_tops.hpp>
namespace rigid {
Vector2d linearized_rates(const Vector3d& I, double omega3) {
  return {omega3 * (I[2] - I[0]) / I[1], omega3 * (I[2] - I[1]) / I[0]};
}
}  // namespace rigid

//! wrong: denominators exchanged
#include <rigid/free_tops.hpp>
namespace rigid {
Vector2d linearized_rates(const Vector3d& I, double omega3) {
  return {omega3 * (I[2] - I[1]) / I[1], omega3 * (I[2] - I[0]) / I[0]};
}
}  // namespace rigid

//! wrong: signs of the equations of motion
#include <rigid/free_tops.hpp>
namespace rigid {
Vector2d linearized_rates(const Vector3d& I, double omega3) {
  return {-omega3 * (I[2] - I[1]) / I[0], omega3 * (I[2] - I[0]) / I[1]};
}
}  // namespace rigid

//! wrong: sizes only
#include <cmath>
#include <rigid/free_tops.hpp>
namespace rigid {
Vector2d linearized_rates(const Vector3d& I, double omega3) {
  const Vector2d rates((I[2] - I[1]) / I[0], (I[2] - I[0]) / I[1]);
  return std::abs(omega3) * rates.cwiseAbs();
}
}  // namespace rigid

//! wrong: a symmetric top is taken for granted
#include <rigid/free_tops.hpp>
namespace rigid {
Vector2d linearized_rates(const Vector3d& I, double omega3) {
  const double Omega = omega3 * (I[2] - I[0]) / I[0];
  return {Omega, Omega};
}
}  // namespace rigid

//! wrong: indices from one
#include <rigid/free_tops.hpp>
namespace rigid {
Vector2d linearized_rates(const Vector3d& I, double omega3) {
  return {omega3 * (I[3] - I[2]) / I[1], omega3 * (I[3] - I[1]) / I[2]};
}
}  // namespace rigid

//! right: from the equations of motion
#include <rigid/free_tops.hpp>
namespace rigid {
Vector2d linearized_rates(const Vector3d& I, double omega3) {
  const double rate1 = (I[1] - I[2]) / I[0] * omega3;
  const double rate2 = (I[2] - I[0]) / I[1] * omega3;
  return {-rate1, rate2};
}
}  // namespace rigid

//! right: element by element
#include <rigid/free_tops.hpp>
namespace rigid {
Vector2d linearized_rates(const Vector3d& I, double omega3) {
  Vector2d rates;
  for (int i = 0; i < 2; ++i) rates[i] = (I[2] - I[1 - i]) * omega3 / I[i];
  return rates;
}
}  // namespace rigid
