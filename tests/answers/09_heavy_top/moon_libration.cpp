#include <cmath>
#include <rigid/heavy_top.hpp>
Vector2d moon_libration(double asymmetry, double eccentricity, double orbital_rate, double theta0, double rate0,
                        double t) {
//! right: Kepler at every step
static double pull(double asymmetry, double eccentricity, double M, double theta) {
  double E = M;
  for (int k = 0; k < 30; ++k) E = E - (E - eccentricity * std::sin(E) - M) / (1 - eccentricity * std::cos(E));
  const double r = 1 - eccentricity * std::cos(E);
  const double f = std::atan2(std::sqrt(1 - eccentricity * eccentricity) * std::sin(E), std::cos(E) - eccentricity);
  (void)r, (void)f;
  return -1.5 * asymmetry * std::sin(2 * (theta - f)) / (r * r * r);
}
Vector2d moon_libration(double asymmetry, double eccentricity, double orbital_rate, double theta0, double rate0,
                        double t) {
  double theta = theta0, rate = rate0 / orbital_rate;
  const int n = 6000;
  const double h = orbital_rate * t / n;
  for (int i = 0; i < n; ++i) {
    const auto a = [&](double M, double x) { return pull(asymmetry, eccentricity, M, x); };
    const double M = i * h, v1 = rate, a1 = a(M, theta), v2 = v1 + h / 2 * a1, a2 = a(M + h / 2, theta + h / 2 * v1);
    const double v3 = v1 + h / 2 * a2, a3 = a(M + h / 2, theta + h / 2 * v2), v4 = v1 + h * a3;
    const double a4 = a(M + h, theta + h * v3);
    theta += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return {theta, rate * orbital_rate};
}
//! wrong: the eccentric anomaly for the direction
-  return -1.5 * asymmetry * std::sin(2 * (theta - f)) / (r * r * r);
+  return -1.5 * asymmetry * std::sin(2 * (theta - E)) / (r * r * r);
//! wrong: Kepler solved with the other sign
-  for (int k = 0; k < 30; ++k) E = E - (E - eccentricity * std::sin(E) - M) / (1 - eccentricity * std::cos(E));
+  for (int k = 0; k < 60; ++k) E = M - eccentricity * std::sin(E);
//! wrong: a compass needle
-  return -1.5 * asymmetry * std::sin(2 * (theta - f)) / (r * r * r);
+  return -3 * asymmetry * std::sin(theta - f) / (r * r * r);
//! wrong: rate in units of the orbit
-  return {theta, rate * orbital_rate};
+  return {theta, rate};
//! wrong: torque with three and not three halves
-  return -1.5 * asymmetry * std::sin(2 * (theta - f)) / (r * r * r);
+  return -3 * asymmetry * std::sin(2 * (theta - f)) / (r * r * r);
//! wrong: 200 steps for every time
-  const int n = 6000;
+  const int n = 200;
//! right: leapfrog in small steps
  const int n = 100000;
  const double h = orbital_rate * t / n, e = eccentricity;
  double theta = theta0, rate = rate0 / orbital_rate, E = 0;
  for (int i = 0; i < n; ++i) {
    theta += h / 2 * rate;
    const double M = (i + 0.5) * h;
    for (int k = 0; k < 4; ++k) E -= (E - e * std::sin(E) - M) / (1 - e * std::cos(E));
    const double r = 1 - e * std::cos(E), c = (std::cos(E) - e) / r, s = std::sqrt(1 - e * e) * std::sin(E) / r;
    const double along = c * std::cos(theta) + s * std::sin(theta), across = s * std::cos(theta) - c * std::sin(theta);
    rate += h * 3 * asymmetry * along * across / (r * r * r);
    theta += h / 2 * rate;
  }
  return {theta, rate * orbital_rate};
//! wrong: mean anomaly for direction and distance
  const auto acc = [&](double s, double th) {
    const double M = orbital_rate * s, r = 1 - eccentricity * std::cos(M);
    return -1.5 * orbital_rate * orbital_rate * asymmetry / (r * r * r) * std::sin(2 * (th - M));
  };
  double th = theta0, w = rate0, s = 0;
  const int n = 4000;
  const double h = t / n;
  for (int i = 0; i < n; ++i, s += h) {
    const double a1 = acc(s, th), a2 = acc(s + h / 2, th + h / 2 * w), a3 = acc(s + h / 2, th + h / 2 * (w + h / 2 * a1)),
                 a4 = acc(s + h, th + h * (w + h / 2 * a2));
    th += h * w + h * h / 6 * (a1 + a2 + a3);
    w += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return {th, w};
//! wrong: sine of the single angle
+  const double n0 = orbital_rate;
   const auto acc = [&](double s, double th) {
-    const double M = orbital_rate * s, r = 1 - eccentricity * std::cos(M);
-    return -1.5 * orbital_rate * orbital_rate * asymmetry / (r * r * r) * std::sin(2 * (th - M));
+    double E = n0 * s;
+    for (int i = 0; i < 50; ++i) E = n0 * s + eccentricity * std::sin(E);
+    for (int i = 0; i < 20; ++i) E -= (E - eccentricity * std::sin(E) - n0 * s) / (1 - eccentricity * std::cos(E));
+    const double r = 1 - eccentricity * std::cos(E);
+    const double f = std::atan2(std::sqrt(1 - eccentricity * eccentricity) * std::sin(E), std::cos(E) - eccentricity);
+    return -1.5 * n0 * n0 * asymmetry / (r * r * r) * std::sin(th - f);
