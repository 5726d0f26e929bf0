#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/free_tops.hpp>
//! wrong: amplitudes of 1 and 3 exchanged
Vector3d separatrix(const Vector3d& I, double spin, double t) {
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))));
}
//! wrong: rate without the spin
Vector3d separatrix(const Vector3d& I, double spin, double t) {
  const double a = std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))));
}
//! wrong: tan for tanh
Vector3d separatrix(const Vector3d& I, double spin, double t) {
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tan(a),
                         p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))));
}
//! wrong: decays from t = 0 as an exponential
Vector3d separatrix(const Vector3d& I, double spin, double t) {
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = std::exp(-std::abs(a));
  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))));
}
