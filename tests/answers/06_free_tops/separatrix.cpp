#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/free_tops.hpp>
Vector3d separatrix(const Vector3d& I, double spin, double t) {
//! wrong: amplitudes of 1 and 3 exchanged
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))));
//! wrong: rate without the spin
  const double a = std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))));
//! wrong: tan for tanh
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tan(a),
                         p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))));
//! wrong: decays from t = 0 as an exponential
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = std::exp(-std::abs(a));
  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))));
