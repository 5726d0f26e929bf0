#include <cmath>
#include <rigid/measured.hpp>
Vector3d damped_rotation(const Vector3d& I, const Vector3d& omega0, double gamma, double t) {
//! right: Runge and Kutta in steps of five milliseconds
  Vector3d w = omega0;
  const int steps = 1 + static_cast<int>(t / 0.005);
  const double h = t / steps;
  const auto f = [&](const Vector3d& u) -> Vector3d {
    return Vector3d(-u.cross(I.cwiseProduct(u)).cwiseQuotient(I)) - gamma * u;
  };
  for (int k = 0; k < steps; ++k) {
    const Vector3d k1 = f(w), k2 = f(w + h / 2 * k1), k3 = f(w + h / 2 * k2), k4 = f(w + h * k3);
    w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return w;
//! wrong: torque against omega
-    return Vector3d(-u.cross(I.cwiseProduct(u)).cwiseQuotient(I)) - gamma * u;
+    return Vector3d((-u.cross(I.cwiseProduct(u)) - gamma * u).cwiseQuotient(I));
//! wrong: torque divided by the moments twice
-    return Vector3d(-u.cross(I.cwiseProduct(u)).cwiseQuotient(I)) - gamma * u;
+    return Vector3d(-u.cross(I.cwiseProduct(u)).cwiseQuotient(I)) - gamma * u.cwiseQuotient(I);
//! wrong: decay afterwards
-  const auto f = [&](const Vector3d& u) -> Vector3d {
-    return Vector3d(-u.cross(I.cwiseProduct(u)).cwiseQuotient(I)) - gamma * u;
-  };
+  const auto f = [&](const Vector3d& u) -> Vector3d { return Vector3d(-u.cross(I.cwiseProduct(u)).cwiseQuotient(I)); };
@@
-  return w;
+  return std::exp(-gamma * t) * w;
//! wrong: 500 steps for every time
-  const int steps = 1 + static_cast<int>(t / 0.005);
+  const int steps = 500;
//! wrong: explicit Euler
  Vector3d w = omega0;
  const int steps = 1 + static_cast<int>(t / 0.001);
  for (int k = 0; k < steps; ++k) w += t / steps * (Vector3d(-w.cross(I.cwiseProduct(w)).cwiseQuotient(I)) - gamma * w);
  return w;
//! wrong: series of the exponential
  auto f = [&](const Vector3d& x) -> Vector3d { return I.cwiseProduct(x).cross(x).cwiseQuotient(I); };
  Vector3d w = omega0;
  const double s = gamma == 0 ? t : (1 - std::exp(-gamma * t)) / gamma;
  const int n = 20000;
  const double h = s / n;
  for (int i = 0; i < n; ++i) {
    const Vector3d a = f(w), b = f(w + h / 2 * a), c = f(w + h / 2 * b), d = f(w + h * c);
    w += h / 6 * (a + 2 * b + 2 * c + d);
  }
  const double x = gamma * t;
  return w * (1 - x + x * x / 2 - x * x * x / 6);
//! wrong: time shortened by the decay at the end
Vector3d damped_rotation(const Vector3d& I, const Vector3d& omega0, double gamma, double t) {
  const double f = std::exp(-gamma * t);
  const double s = t * f;
  const int N = 20000;
  const double h = s / N;
  auto rate = [&](const Vector3d& w) -> Vector3d { return I.cwiseProduct(w).cross(w).cwiseQuotient(I); };
  Vector3d w = omega0;
  for (int i = 0; i < N; i++) {
    const Vector3d a = rate(w), b = rate(w + h / 2 * a), c = rate(w + h / 2 * b), d = rate(w + h * c);
    w += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return f * w;
}
