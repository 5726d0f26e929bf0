#include <cmath>
#include <rigid/free_tops.hpp>
Vector2d linearized_rates(const Vector3d& I, double omega3) {
//! right: from the equations of motion
  const double rate1 = (I[1] - I[2]) / I[0] * omega3;
  const double rate2 = (I[2] - I[0]) / I[1] * omega3;
  return {-rate1, rate2};
//! right: element by element
  Vector2d rates;
  for (int i = 0; i < 2; ++i) rates[i] = (I[2] - I[1 - i]) * omega3 / I[i];
  return rates;
//! wrong: subscripts exchanged
  return {omega3 * (I[2] - I[0]) / I[1], omega3 * (I[2] - I[1]) / I[0]};
//! wrong: denominators exchanged
  return {omega3 * (I[2] - I[1]) / I[1], omega3 * (I[2] - I[0]) / I[0]};
//! wrong: signs of the equations of motion
  return {-omega3 * (I[2] - I[1]) / I[0], omega3 * (I[2] - I[0]) / I[1]};
//! wrong: sizes only
  const Vector2d rates((I[2] - I[1]) / I[0], (I[2] - I[0]) / I[1]);
  return std::abs(omega3) * rates.cwiseAbs();
//! wrong: a symmetric top is taken for granted
  const double Omega = omega3 * (I[2] - I[0]) / I[0];
  return {Omega, Omega};
//! wrong: indices from one
  return {omega3 * (I[3] - I[2]) / I[1], omega3 * (I[3] - I[1]) / I[2]};
//! wrong: denominators exchanged, and the first difference the other way round
  return {omega3 * (I[1] - I[2]) / I[1], omega3 * (I[2] - I[0]) / I[0]};
