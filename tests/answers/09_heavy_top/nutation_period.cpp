#include <cmath>
#include <numbers>
#include <rigid/heavy_top.hpp>
double nutation_period(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
//! right: arithmetic-geometric mean
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
  double x = std::sqrt(beta * (third - low)), y = std::sqrt(beta * (third - high));
  for (int i = 0; i < 50; ++i) {
    const double next = (x + y) / 2;
    y = std::sqrt(x * y);
    x = next;
  }
  return 2 * std::numbers::pi / x;
//! right: midpoints in the angle that removes the ends
-  double x = std::sqrt(beta * (third - low)), y = std::sqrt(beta * (third - high));
-  for (int i = 0; i < 50; ++i) {
-    const double next = (x + y) / 2;
-    y = std::sqrt(x * y);
-    x = next;
+  const int n = 4000;
+  double time = 0;
+  for (int i = 0; i < n; ++i) {
+    const double s = std::sin((i + 0.5) * std::numbers::pi / 2 / n), d = low + (high - low) * s * s;
+    time += 2 * std::numbers::pi / n / std::sqrt(beta * (third - d));
@@
-  return 2 * std::numbers::pi / x;
+  return time;
//! wrong: from one limit to the other
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
  const double m = (high - low) / (third - low);
  return 2 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(beta * (third - low));
//! wrong: difference to the upper limit under the root
-  return 2 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(beta * (third - low));
+  return 4 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(beta * (third - high));
//! wrong: beta without the 2 in the last line
-  return 2 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(beta * (third - low));
+  return 4 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(mgl / I1 * (third - low));
//! wrong: sign of the sum of the roots
-  const double third = (k + b * b) / beta - 2 * u0 - low - high;
+  const double third = 2 * u0 - (k + b * b) / beta - low - high;
@@
-  return 2 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(beta * (third - low));
+  return 4 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(beta * (third - low));
//! wrong: ends of the integral cut off
-  const double third = (k + b * b) / beta - 2 * u0 - low - high;
-  const double m = (high - low) / (third - low);
-  return 2 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(beta * (third - low));
+  const int n = 100000;
+  double time = 0;
+  for (int i = 1; i < n; ++i) {
+    const double d = low + (high - low) * i / n;
+    time += 2 * (high - low) / n / std::sqrt(f(d));
+  }
+  return time;
//! wrong: small nodding at the bottom of the well
  const double p_psi = I3 * (rates[0] * std::cos(theta) + rates[2]);
  const double p_phi = I1 * std::pow(std::sin(theta), 2) * rates[0] + p_psi * std::cos(theta);
  const auto force = [&](double x) {
    const double s = std::sin(x), c = std::cos(x), a = p_phi - p_psi * c;
    return a * (p_psi * s * s - a * c) / (I1 * s * s * s) - mgl * s;
  };
  double low = 1e-6, high = std::numbers::pi - 1e-6;
  for (int i = 0; i < 100; ++i) {
    const double x = (low + high) / 2;
    (force(x) < 0 ? low : high) = x;
  }
  const double h = 1e-5, curvature = (force(low + h) - force(low - h)) / (2 * h);
  return 2 * std::numbers::pi * std::sqrt(I1 / curvature);
//! wrong: a pendulum
double nutation_period(double I1, double, double mgl, double, const Vector3d&) {
  return 2 * std::numbers::pi * std::sqrt(I1 / mgl);
}
//! wrong: midpoints over the cosine: too few pieces
  const double s = std::sin(theta), c = std::cos(theta), w3 = rates[0] * c + rates[2];
  const double pf = I1 * s * s * rates[0] + I3 * w3 * c, pp = I3 * w3;
  const double E = 0.5 * I1 * (s * s * rates[0] * rates[0] + rates[1] * rates[1]) + mgl * c;
  const auto f = [&](double u) { return (E - mgl * u) * 2 * I1 * (1 - u * u) - (pf - pp * u) * (pf - pp * u); };
  double lo = -1, hi = c, lo2 = c, hi2 = 1;
  for (int i = 0; i < 100; ++i) {
    const double m = (lo + hi) / 2;
    (f(m) < 0 ? lo : hi) = m;
    const double m2 = (lo2 + hi2) / 2;
    (f(m2) < 0 ? hi2 : lo2) = m2;
  }
  double P = 0;
  const int n = 1000;
  for (int i = 0; i < n; ++i) {
    const double u = hi + (lo2 - hi) * (i + 0.5) / n;
    P += 2 * (lo2 - hi) / n * I1 / std::sqrt(f(u));
  }
  return P;
