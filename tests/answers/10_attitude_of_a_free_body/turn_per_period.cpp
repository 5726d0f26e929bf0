#include <algorithm>
#include <cmath>
#include <utility>
#include <rigid/attitude_of_a_free_body.hpp>
double turn_per_period(const Vector3d& I, const Vector3d& omega0) {
//! right: sum over equal steps of a period
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
double turn_per_period(const Vector3d& I, const Vector3d& omega0) {
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
  return angle;
}
//! wrong: angle about axis 3 itself
-  const double P = period(I, omega0), L = I.cwiseProduct(omega0).norm();
+  const double P = period(I, omega0);
@@
-    const double x = I[0] * w[0] * w[0] + I[1] * w[1] * w[1];
-    const double y = I[0] * I[0] * w[0] * w[0] + I[1] * I[1] * w[1] * w[1];
-    angle += L * x / y * P / n;
+    angle += w[2] * P / n;
//! wrong: velocity of the tip without its distance from the line of L
-    const double y = I[0] * I[0] * w[0] * w[0] + I[1] * I[1] * w[1] * w[1];
-    angle += L * x / y * P / n;
+    angle += x / L * P / n;
//! wrong: followed for a quarter and doubled
-    angle += L * x / y * P / n;
-    w = step(I, w, P / n);
+    angle += L * x / y * P / 4 / n;
+    w = step(I, w, P / 4 / n);
   }
-  return angle;
+  return 2 * angle;
//! wrong: turn of the attitude, without the whole turns
-  return angle;
+  return std::fmod(angle, 2 * M_PI);
//! wrong: axis 1 followed
-    const double x = I[0] * w[0] * w[0] + I[1] * w[1] * w[1];
-    const double y = I[0] * I[0] * w[0] * w[0] + I[1] * I[1] * w[1] * w[1];
+    const double x = I[2] * w[2] * w[2] + I[1] * w[1] * w[1];
+    const double y = I[2] * I[2] * w[2] * w[2] + I[1] * I[1] * w[1] * w[1];
//! right: closed form with the integral of the third kind
  double I1 = I[0], I3 = I[2], T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  const bool other = L2 < T2 * I[1];
  const double cot2 = I3 * (L2 - T2 * I1) / (I1 * (T2 * I3 - L2));
  const double below = other ? T2 * I1 - L2 : T2 * I3 - L2, above = other ? L2 - T2 * I3 : L2 - T2 * I1;
  const double p = other ? I3 : I1, q = other ? I1 : I3;
  const double nu = std::sqrt(above * (q - I[1]) / (I[0] * I[1] * I[2]));
  const double k2 = below * (I[1] - p) / (above * (q - I[1])), k = std::sqrt(k2);
  const double L = std::sqrt(L2), P = 4 * std::comp_ellint_1(k) / nu;
  const double n = other ? -cot2 : -k2 * cot2;
  return L * P / I3 + 4 * L * (I3 - I1) / (I1 * I3 * nu) * std::comp_ellint_3(k, n);
//! wrong: sign of n
-  const double n = other ? -cot2 : -k2 * cot2;
+  const double n = other ? cot2 : k2 * cot2;
//! wrong: the same n for both kinds of motion
-  const double n = other ? -cot2 : -k2 * cot2;
-  return L * P / I3 + 4 * L * (I3 - I1) / (I1 * I3 * nu) * std::comp_ellint_3(k, n);
+  return L * P / I3 + 4 * L * (I3 - I1) / (I1 * I3 * nu) * std::comp_ellint_3(k, -k2 * cot2);
//! wrong: the rate of a symmetric top
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
double turn_per_period(const Vector3d& I, const Vector3d& omega0) {
  return I.cwiseProduct(omega0).norm() / I[0] * period(I, omega0);
}
//! wrong: component of omega along L
-  return I.cwiseProduct(omega0).norm() / I[0] * period(I, omega0);
+  const Vector3d L = I.cwiseProduct(omega0);
+  return omega0.dot(L) / L.norm() * period(I, omega0);
//! right: trapezoidal rule over a period
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  double a = I[0], b = I[1], c = I[2];
  if (L2 < T2 * b) std::swap(a, c);
  const double nu = std::sqrt((L2 - T2 * a) * (c - b) / (a * b * c));
  const double m = (T2 * c - L2) * (b - a) / ((L2 - T2 * a) * (c - b));
  const double P = 4 * std::comp_ellint_1(std::sqrt(std::max(m, 0.0))) / nu;
  auto f = [&](const Vector3d& x) -> Vector3d { return I.cwiseProduct(x).cross(x).cwiseQuotient(I); };
  const int n = 40000;
  const double h = P / n;
  Vector3d w = omega0;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double x = I[0] * w[0], y = I[1] * w[1];
    sum += (x * w[0] + y * w[1]) / (x * x + y * y);
    const Vector3d k1 = f(w), k2 = f(w + h / 2 * k1), k3 = f(w + h / 2 * k2), k4 = f(w + h * k3);
    w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return std::sqrt(L2) * sum * h;
//! wrong: another index in both factors of a square
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  double a = I[0], b = I[1], c = I[2];
  if (L2 < T2 * b) std::swap(a, c);
  const double nu = std::sqrt((L2 - T2 * a) * (c - b) / I.prod());
  const double m = (T2 * c - L2) * (b - a) / ((L2 - T2 * a) * (c - b));
  const double P = 4 * std::comp_ellint_1(std::sqrt(m)) / nu;
  const auto f = [&](const Vector3d& w) -> Vector3d { return -w.cross(I.cwiseProduct(w)).cwiseQuotient(I); };
  const int n = 4000;
  const double h = P / n, L = std::sqrt(L2);
  Vector3d w = omega0;
  double phi = 0;
  for (int i = 0; i < n; ++i) {
    phi += h * L * (I[0] * w[0] * w[0] + I[1] * w[1] * w[1]) / (I[0] * I[0] * w[0] * w[0] + I[2] * I[2] * w[1] * w[1]);
    const Vector3d k1 = f(w), k2 = f(w + h / 2 * k1), k3 = f(w + h / 2 * k2), k4 = f(w + h * k3);
    w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return phi;
