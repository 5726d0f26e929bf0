#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/free_tops.hpp>
Vector3d separatrix(const Vector3d& I, double spin, double t) {
//! right: hyperbolic functions
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))));
//! wrong: rate without the spin
-  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
+  const double a = std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
//! wrong: tan for tanh
-  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tanh(a),
+  return spin * Vector3d(p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))), std::tan(a),
//! wrong: decays from t = 0 as an exponential
-  const double p = 1 / std::cosh(a);
+  const double p = std::exp(-std::abs(a));
//! wrong: amplitudes of 1 and 3 exchanged
  const double a = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) * t;
  const double p = 1 / std::cosh(a);
  return spin * Vector3d(p * std::sqrt(I[1] * (I[1] - I[0]) / (I[2] * (I[2] - I[0]))), std::tanh(a),
                         p * std::sqrt(I[1] * (I[2] - I[1]) / (I[0] * (I[2] - I[0]))));
//! right: by exponentials
  const double s = spin * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2]));
  const double e = std::exp(-std::abs(s * t)), q = 1 + e * e;
  const double n = std::sqrt(I[1] / (I[2] - I[0])) * 2 * e / q * spin;
  return {n * std::sqrt((I[2] - I[1]) / I[0]), std::copysign(spin * (1 - e * e) / q, t), n * std::sqrt((I[1] - I[0]) / I[2])};
//! wrong: a thousand steps, whatever the time
  const double T2 = I[1] * spin * spin, L2 = T2 * I[1];
  Vector3d w(std::sqrt((T2 * I[2] - L2) / (I[0] * (I[2] - I[0]))), 0, std::sqrt((L2 - T2 * I[0]) / (I[2] * (I[2] - I[0]))));
  auto f = [&](const Vector3d& v) -> Vector3d { return I.cwiseProduct(v).cross(v).cwiseQuotient(I); };
  const int n = 1000;
  const double h = t / n;
  for (int k = 0; k < n; ++k) {
    const Vector3d a = f(w), b = f(w + h / 2 * a), c = f(w + h / 2 * b), d = f(w + h * c);
    w += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return w;
