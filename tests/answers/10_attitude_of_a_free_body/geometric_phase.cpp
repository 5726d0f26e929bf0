#include <algorithm>
#include <cmath>
#include <utility>
#include <rigid/attitude_of_a_free_body.hpp>
double geometric_phase(const Vector3d& I, const Vector3d& omega0) {
//! right: area over equal steps of the azimuth
  int a = 0, b = 1, c = 2;
  const Vector3d L = I.cwiseProduct(omega0);
  const double E = omega0.dot(L) / L.squaredNorm();
  if (E * I[1] > 1) std::swap(a, c);
  const int steps = 4000;
  double area = 0;
  for (int i = 0; i < steps; ++i) {
    const double chi = 2 * M_PI * i / steps, x = std::cos(chi), y = std::sin(chi);
    const double sin2 = (E - 1 / I[c]) / (x * x / I[a] + y * y / I[b] - 1 / I[c]);
    area += (1 - std::sqrt(1 - sin2)) * 2 * M_PI / steps;
  }
  return area;
//! wrong: area projected along the axis
-    area += (1 - std::sqrt(1 - sin2)) * 2 * M_PI / steps;
+    area += sin2 / 2 * 2 * M_PI / steps;
//! wrong: cosine of the angle left out: the other side
-    area += (1 - std::sqrt(1 - sin2)) * 2 * M_PI / steps;
+    area += (1 + std::sqrt(1 - sin2)) * 2 * M_PI / steps;
//! wrong: round axis 3, whatever the motion
-  int a = 0, b = 1, c = 2;
+  const int a = 0, b = 1, c = 2;
@@
-  if (E * I[1] > 1) std::swap(a, c);
@@
-    area += (1 - std::sqrt(1 - sin2)) * 2 * M_PI / steps;
+    area += (1 - std::sqrt(std::max(0.0, 1 - sin2))) * 2 * M_PI / steps;
//! wrong: curve of omega in place of that of L
-  const double E = omega0.dot(L) / L.squaredNorm();
-  if (E * I[1] > 1) std::swap(a, c);
+  const double T2 = omega0.dot(L), L2 = L.squaredNorm();
+  if (T2 * I[1] > L2) std::swap(a, c);
@@
-    const double sin2 = (E - 1 / I[c]) / (x * x / I[a] + y * y / I[b] - 1 / I[c]);
+    const double sin2 = (T2 * I[c] - L2) * I[c] /
+                        ((T2 * I[c] - L2) * I[c] + x * x * I[a] * (L2 - T2 * I[a]) + y * y * I[b] * (L2 - T2 * I[b]));
//! right: turn about L less the mean rate times the period
static double period(const Vector3d& I, const Vector3d& w) {
  double a = I[0], b = I[1], c = I[2], x = w[0], y = w[1], z = w[2];
  if (a * (b - a) * x * x > c * (c - b) * z * z) {
    std::swap(a, c);
    std::swap(x, z);
  }
  const double below = a * (c - a) * x * x + b * (c - b) * y * y;
  const double above = b * (b - a) * y * y + c * (c - a) * z * z;
  return 4 * std::comp_ellint_1(std::sqrt(below * (b - a) / (above * (c - b)))) /
         std::sqrt(above * (c - b) / (a * b * c));
}
static Vector3d rate(const Vector3d& I, const Vector3d& w) {
  return Vector3d((I[1] - I[2]) * w[1] * w[2], (I[2] - I[0]) * w[2] * w[0], (I[0] - I[1]) * w[0] * w[1])
      .cwiseQuotient(I);
}
static Vector3d step(const Vector3d& I, const Vector3d& w, double h) {
  const Vector3d a = rate(I, w), b = rate(I, w + h / 2 * a), c = rate(I, w + h / 2 * b), d = rate(I, w + h * c);
  return w + h / 6 * (a + 2 * b + 2 * c + d);
}
double geometric_phase(const Vector3d& I, const Vector3d& omega0) {
  const double P = period(I, omega0), L = I.cwiseProduct(omega0).norm();
  const int n = 8000;
  Vector3d w = omega0;
  double angle = 0;
  for (int i = 0; i < n; ++i) {
    const double x = I[0] * w[0] * w[0] + I[1] * w[1] * w[1];
    const double y = I[0] * I[0] * w[0] * w[0] + I[1] * I[1] * w[1] * w[1];
    angle += L * x / y * P / n;
    w = step(I, w, P / n);
  }
  const double mean = P * omega0.dot(I.cwiseProduct(omega0)) / L;
  const bool round_3 = L * L > I[1] * omega0.dot(I.cwiseProduct(omega0));
  return round_3 ? mean + 2 * M_PI - angle : angle - mean;
}
//! wrong: polygon of 300 triangles
-  const double P = period(I, omega0), L = I.cwiseProduct(omega0).norm();
-  const int n = 8000;
+  const Vector3d L = I.cwiseProduct(omega0);
+  const bool round_3 = L.squaredNorm() > I[1] * omega0.dot(L);
+  const Vector3d pole =
+      round_3 ? Vector3d(0, 0, std::copysign(1.0, omega0[2])) : Vector3d(std::copysign(1.0, omega0[0]), 0, 0);
+  const double P = period(I, omega0);
+  const int n = 300;
+  double area = 0;
   Vector3d w = omega0;
-  double angle = 0;
   for (int i = 0; i < n; ++i) {
-    const double x = I[0] * w[0] * w[0] + I[1] * w[1] * w[1];
-    const double y = I[0] * I[0] * w[0] * w[0] + I[1] * I[1] * w[1] * w[1];
-    angle += L * x / y * P / n;
+    const Vector3d p = I.cwiseProduct(w).normalized();
     w = step(I, w, P / n);
+    const Vector3d q = I.cwiseProduct(w).normalized();
+    area += 2 * std::atan2(pole.dot(p.cross(q)), 1 + pole.dot(p) + p.dot(q) + q.dot(pole));
   }
-  const double mean = P * omega0.dot(I.cwiseProduct(omega0)) / L;
-  const bool round_3 = L * L > I[1] * omega0.dot(I.cwiseProduct(omega0));
-  return round_3 ? mean + 2 * M_PI - angle : angle - mean;
+  return std::abs(area);
//! wrong: sign of motion round axis 3 for both kinds
-  const double mean = P * omega0.dot(I.cwiseProduct(omega0)) / L;
-  const bool round_3 = L * L > I[1] * omega0.dot(I.cwiseProduct(omega0));
-  return round_3 ? mean + 2 * M_PI - angle : angle - mean;
+  const double S = 2 * M_PI + P * omega0.dot(I.cwiseProduct(omega0)) / L - angle;
+  return S - 2 * M_PI * std::floor(S / (2 * M_PI));
//! wrong: the turn itself, without whole turns
-  const double mean = P * omega0.dot(I.cwiseProduct(omega0)) / L;
-  const bool round_3 = L * L > I[1] * omega0.dot(I.cwiseProduct(omega0));
-  return round_3 ? mean + 2 * M_PI - angle : angle - mean;
+  return std::fmod(angle, 2 * M_PI);
//! wrong: a circle through the start
  const Vector3d n = I.cwiseProduct(omega0).normalized();
  const bool round_3 = I.cwiseProduct(omega0).squaredNorm() > I[1] * I.dot(omega0.cwiseAbs2());
  return 2 * M_PI * (1 - std::abs(round_3 ? n[2] : n[0]));
//! wrong: round axis 3 always
  auto f = [&](const Vector3d& x) -> Vector3d { return I.cwiseProduct(x).cross(x).cwiseQuotient(I); };
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  double a = I[0], b = I[1], c = I[2];
  if (L2 < T2 * b) std::swap(a, c);
  const double nu = std::sqrt((L2 - T2 * a) * (c - b) / (a * b * c));
  const double m = (T2 * c - L2) * (b - a) / ((L2 - T2 * a) * (c - b));
  const double P = 4 * std::comp_ellint_1(std::sqrt(std::max(m, 0.0))) / nu;
  const int n = 20000;
  const double h = P / n;
  Vector3d w = omega0;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const Vector3d v = I.cwiseProduct(w), dv = I.cwiseProduct(f(w));
    sum += h * (1 - std::abs(v[2]) / v.norm()) * (v[0] * dv[1] - v[1] * dv[0]) / (v[0] * v[0] + v[1] * v[1]);
    const Vector3d k1 = f(w), k2 = f(w + h / 2 * k1), k3 = f(w + h / 2 * k2), k4 = f(w + h * k3);
    w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return std::abs(sum);
