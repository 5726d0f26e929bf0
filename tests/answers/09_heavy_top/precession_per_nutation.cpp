#include <cmath>
#include <numbers>
#include <rigid/heavy_top.hpp>
double precession_per_nutation(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
//! right: midpoints in the angle that removes the ends
  const double u0 = std::cos(theta), s2 = std::pow(std::sin(theta), 2), p = rates[0];
  const double b = I3 * (p * u0 + rates[2]) / I1, beta = 2 * mgl / I1, k = p * p * s2 + rates[1] * rates[1];
  const auto f = [&](double d) {
    return s2 * rates[1] * rates[1] + d * (2 * b * p * s2 - 2 * u0 * k - beta * s2) +
           d * d * (2 * u0 * beta - k - b * b) + beta * d * d * d;
  };
  double lowest = -1 - u0, low = 0, high = 0, highest = 1 - u0;
  for (int i = 0; i < 200; ++i) {
    const double x = (lowest + low) / 2, y = (high + highest) / 2;
    (f(x) < 0 ? lowest : low) = x;
    (f(y) < 0 ? highest : high) = y;
  }
  const double third = (k + b * b) / beta - 2 * u0 - low - high;
  const int n = 4000;
  double angle = 0;
  for (int i = 0; i < n; ++i) {
    const double s = std::sin((i + 0.5) * std::numbers::pi / 2 / n), d = low + (high - low) * s * s, u = u0 + d;
    const double dt = 2 * std::numbers::pi / n / std::sqrt(beta * (third - d));
    angle += (p * s2 - b * d) / ((1 - u) * (1 + u)) * dt;
  }
  return angle;
//! wrong: sine not squared
-    angle += (p * s2 - b * d) / ((1 - u) * (1 + u)) * dt;
+    angle += (p * s2 - b * d) / std::sqrt(1 - u * u) * dt;
//! wrong: psi in place of phi
-    angle += (p * s2 - b * d) / ((1 - u) * (1 + u)) * dt;
+    angle += (I1 / I3 * b - u * (p * s2 - b * d) / (1 - u * u)) * dt;
//! wrong: momenta exchanged
-    angle += (p * s2 - b * d) / ((1 - u) * (1 + u)) * dt;
+    angle += (b - (p * s2 + b * u0) * u) / (1 - u * u) * dt;
//! wrong: mean of the rates at both limits
-  const int n = 4000;
-  double angle = 0;
-  for (int i = 0; i < n; ++i) {
-    const double s = std::sin((i + 0.5) * std::numbers::pi / 2 / n), d = low + (high - low) * s * s, u = u0 + d;
-    const double dt = 2 * std::numbers::pi / n / std::sqrt(beta * (third - d));
-    angle += (p * s2 - b * d) / ((1 - u) * (1 + u)) * dt;
-  }
-  return angle;
+  const double period =
+      4 * std::comp_ellint_1(std::sqrt((high - low) / (third - low))) / std::sqrt(beta * (third - low));
+  const auto rate = [&](double d) { return (p * s2 - b * d) / (1 - (u0 + d) * (u0 + d)); };
+  return period * (rate(low) + rate(high)) / 2;
//! wrong: whole turns taken away
-    angle += (p * s2 - b * d) / ((1 - u) * (1 + u)) * dt;
+    angle += (p * s2 - b * d) / (1 - u * u) * dt;
@@
-  return angle;
+  return std::remainder(angle, 2 * std::numbers::pi);
//! wrong: loops counted forwards
-    angle += (p * s2 - b * d) / ((1 - u) * (1 + u)) * dt;
+    angle += std::abs(p * s2 - b * d) / (1 - u * u) * dt;
//! wrong: one half period only
-    angle += (p * s2 - b * d) / ((1 - u) * (1 + u)) * dt;
+    angle += (p * s2 - b * d) / (1 - u * u) * dt / 2;
//! wrong: 200 trapezoids in u
-  const double third = (k + b * b) / beta - 2 * u0 - low - high;
-  const int n = 4000;
+  const int n = 200;
@@
-  for (int i = 0; i < n; ++i) {
-    const double s = std::sin((i + 0.5) * std::numbers::pi / 2 / n), d = low + (high - low) * s * s, u = u0 + d;
-    const double dt = 2 * std::numbers::pi / n / std::sqrt(beta * (third - d));
-    angle += (p * s2 - b * d) / ((1 - u) * (1 + u)) * dt;
+  for (int i = 1; i < n; ++i) {
+    const double d = low + (high - low) * i / n;
+    angle += 2 * (high - low) / n * (p * s2 - b * d) / (1 - (u0 + d) * (u0 + d)) / std::sqrt(f(d));
//! right: partial fractions, two integrals of the third kind
-  const int n = 4000;
-  double angle = 0;
-  for (int i = 0; i < n; ++i) {
-    const double s = std::sin((i + 0.5) * std::numbers::pi / 2 / n), d = low + (high - low) * s * s, u = u0 + d;
-    const double dt = 2 * std::numbers::pi / n / std::sqrt(beta * (third - d));
-    angle += (p * s2 - b * d) / ((1 - u) * (1 + u)) * dt;
-  }
-  return angle;
+  const double m = (high - low) / (third - low), u1 = u0 + low;
+  // (a − bu)/(1 − u²) = (a − b)/2/(1 − u) + (a + b)/2/(1 + u)
+  const double upper = p * s2 - b * (1 - u0), lower = p * s2 + b * (1 + u0);
+  const double P = std::comp_ellint_3(std::sqrt(m), (high - low) / (1 - u1));
+  const double Q = std::comp_ellint_3(std::sqrt(m), -(high - low) / (1 + u1));
+  return 2 / std::sqrt(beta * (third - low)) * (upper / (1 - u1) * P + lower / (1 + u1) * Q);
//! wrong: rate and period of a fast top
  const double s = std::sin(theta), c = std::cos(theta), w3 = rates[0] * c + rates[2];
  const double P = 2 * std::numbers::pi * I1 / std::abs(I3 * w3);
  return mgl / (I3 * w3) * P + 0 * s;
