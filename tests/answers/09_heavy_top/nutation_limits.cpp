#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/heavy_top.hpp>
Vector2d nutation_limits(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
//! right: halved intervals of the cubic about the start
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
  return {std::acos(u0 + high), std::acos(u0 + low)};
//! wrong: order of the cosines
-  return {std::acos(u0 + high), std::acos(u0 + low)};
+  return {std::acos(u0 + low), std::acos(u0 + high)};
//! right: Viète's cosines for the three roots, each polished with Newton's rule
  const double u0 = std::cos(theta), s2 = std::pow(std::sin(theta), 2), p = rates[0], q = rates[1];
  const double b = I3 * (p * u0 + rates[2]) / I1, beta = 2 * mgl / I1, k = p * p * s2 + q * q;
  const double c0 = s2 * q * q / beta, c1 = (2 * b * p * s2 - 2 * u0 * k) / beta - s2, c2 = 2 * u0 - (k + b * b) / beta;
  const double m = -c2 / 3, r = std::sqrt(std::max(0.0, m * m - c1 / 3));
  const double h = m * m * m - 0.5 * (m * c1 + c0);  // half of −f at the middle
  const double w = std::acos(std::clamp(h / (r * r * r), -1.0, 1.0)) / 3;
  double d[2] = {m + 2 * r * std::cos(w + 2 * std::numbers::pi / 3),
                 m + 2 * r * std::cos(w + 4 * std::numbers::pi / 3)};
  for (double& x : d)
    for (int i = 0; i < 40; ++i) {
      const double f = ((x + c2) * x + c1) * x + c0, slope = (3 * x + 2 * c2) * x + c1;
      if (slope != 0) x -= f / slope;
    }
  std::sort(d, d + 2);
  return {std::acos(u0 + d[1]), std::acos(u0 + d[0])};
//! wrong: the third term of omega3 without its cosine
  const double u = std::cos(theta), s2 = std::pow(std::sin(theta), 2);
  const double spin = rates[0] + rates[2], b = I3 * spin / I1, a = rates[0] * s2 + b * u, beta = 2 * mgl / I1;
  const double alpha = rates[0] * rates[0] * s2 + rates[1] * rates[1] + beta * u;
  const auto f = [&](double x) { return (1 - x * x) * (alpha - beta * x) - (a - b * x) * (a - b * x); };
  double lowest = -1, low = u, high = u, highest = 1;
  for (int i = 0; i < 100; ++i) {
    const double x = (lowest + low) / 2, y = (high + highest) / 2;
    (f(x) < 0 ? lowest : low) = x;
    (f(y) < 0 ? highest : high) = y;
  }
  return {std::acos(high), std::acos(low)};
//! wrong: energy of the spin counted in alpha
-  const double u = std::cos(theta), s2 = std::pow(std::sin(theta), 2);
-  const double spin = rates[0] + rates[2], b = I3 * spin / I1, a = rates[0] * s2 + b * u, beta = 2 * mgl / I1;
-  const double alpha = rates[0] * rates[0] * s2 + rates[1] * rates[1] + beta * u;
+  const double u = std::cos(theta), s2 = std::pow(std::sin(theta), 2), spin = rates[0] * u + rates[2];
+  const double E = 0.5 * I1 * (rates[0] * rates[0] * s2 + rates[1] * rates[1]) + 0.5 * I3 * spin * spin + mgl * u;
+  const double b = I3 * spin / I1, a = rates[0] * s2 + b * u, beta = 2 * mgl / I1, alpha = 2 * E / I1;
//! wrong: the two largest roots of the cubic
  const double u = std::cos(theta), s2 = std::pow(std::sin(theta), 2);
  const double spin = rates[0] * u + rates[2], b = I3 * spin / I1, a = rates[0] * s2 + b * u, beta = 2 * mgl / I1;
  const double alpha = rates[0] * rates[0] * s2 + rates[1] * rates[1] + beta * u;
  // β u³ − (α + b²) u² + (2ab − β) u + α − a²
  Matrix3d C;
  C << (alpha + b * b) / beta, (beta - 2 * a * b) / beta, (a * a - alpha) / beta, 1, 0, 0, 0, 1, 0;
  Vector3d roots = C.eigenvalues().real();
  std::sort(roots.begin(), roots.end());
  return {std::acos(roots[2]), std::acos(roots[1])};
//! wrong: the start taken for a limit
  const double u0 = std::cos(theta), s2 = std::pow(std::sin(theta), 2), p = rates[0];
  const double b = I3 * (p * u0 + rates[2]) / I1, beta = 2 * mgl / I1, k = p * p * s2;
  // cubic in d = u − u0 divided by d
  const double A = beta, B = 2 * u0 * beta - k - b * b, C = 2 * b * p * s2 - 2 * u0 * k - beta * s2;
  const double d = 2 * C / (-B + std::sqrt(B * B - 4 * A * C));
  const double other = std::acos(std::clamp(u0 + d, -1.0, 1.0));
  return {std::min(theta, other), std::max(theta, other)};
//! wrong: looks in steps of a thousandth
  const double p_psi = I3 * (rates[0] * std::cos(theta) + rates[2]);
  const double p_phi = I1 * std::pow(std::sin(theta), 2) * rates[0] + p_psi * std::cos(theta);
  const auto U = [&](double x) {
    return std::pow((p_phi - p_psi * std::cos(x)) / std::sin(x), 2) / (2 * I1) + mgl * std::cos(x);
  };
  const double E = U(theta) + 0.5 * I1 * rates[1] * rates[1];
  double low = theta, high = theta;
  while (low > 0 && U(low) <= E) low -= 1e-3;
  while (high < std::numbers::pi && U(high) <= E) high += 1e-3;
  return {low, high};
//! wrong: limits on a grid
  const double s = std::sin(theta), c = std::cos(theta), w3 = rates[0] * c + rates[2];
  const double pf = I1 * s * s * rates[0] + I3 * w3 * c, pp = I3 * w3;
  const double E = 0.5 * I1 * (s * s * rates[0] * rates[0] + rates[1] * rates[1]) + mgl * c;
  const auto V = [&](double x) { return std::pow(pf - pp * std::cos(x), 2) / (2 * I1 * std::pow(std::sin(x), 2)) + mgl * std::cos(x); };
  double lo = theta, hi = theta;
  const double h = std::numbers::pi / 1000;
  while (lo > h && V(lo - h) < E) lo -= h;
  while (hi < std::numbers::pi - h && V(hi + h) < E) hi += h;
  return {lo, hi};
