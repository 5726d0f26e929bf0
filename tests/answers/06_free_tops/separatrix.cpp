//! wrong: amplitudes of 1 and 3 exchanged
#include "rigid/free_tops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d separatrix(const Vector3d& I, double spin, double t) {
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))));
}

}  // namespace rigid
//! wrong: rate without the spin
#include "rigid/free_tops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d separatrix(const Vector3d& I, double spin, double t) {
  const double a = std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))));
}

}  // namespace rigid
//! wrong: tan for tanh
#include "rigid/free_tops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d separatrix(const Vector3d& I, double spin, double t) {
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tan(a),
                         p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))));
}

}  // namespace rigid
//! wrong: decays from t = 0 as an exponential
#include "rigid/free_tops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d separatrix(const Vector3d& I, double spin, double t) {
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = std::exp(-std::abs(a));
  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))));
}

}  // namespace rigid
