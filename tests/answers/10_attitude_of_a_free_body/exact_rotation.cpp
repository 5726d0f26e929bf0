#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <rigid/attitude_of_a_free_body.hpp>
Vector3d exact_rotation(const Vector3d& I, const Vector3d& omega0, double t) {
//! right: Jacobi's functions of the library
  double I1 = I[0], I2 = I[1], I3 = I[2];
  Vector3d w = omega0;
  const bool other = I1 * (I2 - I1) * w[0] * w[0] > I3 * (I3 - I2) * w[2] * w[2];
  if (other) std::swap(I1, I3), std::swap(w[0], w[2]);
  // with the labels exchanged both factors of each product change their sign
  const double below = I1 * (I3 - I1) * w[0] * w[0] + I2 * (I3 - I2) * w[1] * w[1];
  const double above = I2 * (I2 - I1) * w[1] * w[1] + I3 * (I3 - I1) * w[2] * w[2];
  const double a1 = std::sqrt(below / (I1 * (I3 - I1))), a2 = std::sqrt(below / (I2 * (I3 - I2)));
  const double a3 = std::sqrt(above / (I3 * (I3 - I1))), s = std::copysign(1.0, w[2]);
  const double nu = std::sqrt(above * (I3 - I2) / (I1 * I2 * I3));
  const double k = std::sqrt(below * (I2 - I1) / (above * (I3 - I2)));
  const double u0 = boost::math::ellint_1(k, std::atan2(s * w[1] / a2, w[0] / a1));
  double cn, dn;
  const double sn = boost::math::jacobi_elliptic(k, nu * t + u0, &cn, &dn);
  Vector3d result(a1 * cn, s * a2 * sn, s * a3 * dn);
  if (other) std::swap(result[0], result[2]);
  return result;
//! wrong: quadrant of the phase lost
-  // with the labels exchanged both factors of each product change their sign
@@
-  const double u0 = boost::math::ellint_1(k, std::atan2(s * w[1] / a2, w[0] / a1));
+  const double u0 = boost::math::ellint_1(k, std::asin(std::clamp(s * w[1] / a2, -1.0, 1.0)));
//! wrong: labels exchanged and never exchanged back
-  const bool other = I1 * (I2 - I1) * w[0] * w[0] > I3 * (I3 - I2) * w[2] * w[2];
-  if (other) std::swap(I1, I3), std::swap(w[0], w[2]);
-  // with the labels exchanged both factors of each product change their sign
+  if (I1 * (I2 - I1) * w[0] * w[0] > I3 * (I3 - I2) * w[2] * w[2]) std::swap(I1, I3), std::swap(w[0], w[2]);
@@
-  Vector3d result(a1 * cn, s * a2 * sn, s * a3 * dn);
-  if (other) std::swap(result[0], result[2]);
-  return result;
+  return {a1 * cn, s * a2 * sn, s * a3 * dn};
//! wrong: third component always positive
-  // with the labels exchanged both factors of each product change their sign
@@
-  const double a3 = std::sqrt(above / (I3 * (I3 - I1))), s = std::copysign(1.0, w[2]);
+  const double a3 = std::sqrt(above / (I3 * (I3 - I1)));
@@
-  const double u0 = boost::math::ellint_1(k, std::atan2(s * w[1] / a2, w[0] / a1));
+  const double u0 = boost::math::ellint_1(k, std::atan2(w[1] / a2, w[0] / a1));
@@
-  Vector3d result(a1 * cn, s * a2 * sn, s * a3 * dn);
+  Vector3d result(a1 * cn, a2 * sn, a3 * dn);
//! wrong: parameter given where the modulus is asked for
-  // with the labels exchanged both factors of each product change their sign
@@
-  const double k = std::sqrt(below * (I2 - I1) / (above * (I3 - I2)));
-  const double u0 = boost::math::ellint_1(k, std::atan2(s * w[1] / a2, w[0] / a1));
+  const double m = below * (I2 - I1) / (above * (I3 - I2));
+  const double u0 = boost::math::ellint_1(m, std::atan2(s * w[1] / a2, w[0] / a1));
   double cn, dn;
-  const double sn = boost::math::jacobi_elliptic(k, nu * t + u0, &cn, &dn);
+  const double sn = boost::math::jacobi_elliptic(m, nu * t + u0, &cn, &dn);
//! right: whole periods left out, the remainder integrated
  double a = I[0], b = I[1], c = I[2], x = omega0[0], y = omega0[1], z = omega0[2];
  if (a * (b - a) * x * x > c * (c - b) * z * z) {
    std::swap(a, c);
    std::swap(x, z);
  }
  const double below = a * (c - a) * x * x + b * (c - b) * y * y;
  const double above = b * (b - a) * y * y + c * (c - a) * z * z;
  const double k = std::sqrt(below * (b - a) / (above * (c - b)));
  const double P = 4 * boost::math::ellint_1(k) / std::sqrt(above * (c - b) / (a * b * c));
  const auto rate = [&](const Vector3d& w) {
    return Vector3d((I[1] - I[2]) * w[1] * w[2] / I[0], (I[2] - I[0]) * w[2] * w[0] / I[1],
                    (I[0] - I[1]) * w[0] * w[1] / I[2]);
  };
  const int n = 20000;
  const double h = std::remainder(t, P) / n;
  Vector3d w = omega0;
  for (int i = 0; i < n; ++i) {
    const Vector3d p = rate(w), q = rate(w + h / 2 * p), r = rate(w + h / 2 * q), s = rate(w + h * r);
    w += h / 6 * (p + 2 * q + 2 * r + s);
  }
  return w;
//! wrong: fifty thousand steps, however long the time
  const auto rate = [&](const Vector3d& w) {
    return Vector3d((I[1] - I[2]) * w[1] * w[2] / I[0], (I[2] - I[0]) * w[2] * w[0] / I[1],
                    (I[0] - I[1]) * w[0] * w[1] / I[2]);
  };
  const int n = 50000;
  const double h = t / n;
  Vector3d w = omega0;
  for (int i = 0; i < n; ++i) {
    const Vector3d a = rate(w), b = rate(w + h / 2 * a), c = rate(w + h / 2 * b), d = rate(w + h * c);
    w += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return w;
//! wrong: remainder after periods of a small wobble
-  const int n = 50000;
-  const double h = t / n;
+  const double P = 2 * std::numbers::pi / (omega0.norm() * std::sqrt((I[2] - I[0]) * (I[2] - I[1]) / (I[0] * I[1])));
+  const int n = 10000;
+  const double h = std::remainder(t, P) / n;
//! wrong: steps of a hundredth of a second up to the end
-  const int n = 50000;
-  const double h = t / n;
   Vector3d w = omega0;
-  for (int i = 0; i < n; ++i) {
+  const double h = std::copysign(0.01, t);
+  for (double time = 0; std::abs(time) < std::abs(t); time += h) {
//! wrong: half a period for a whole one: signs are lost
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  double a = I[0], b = I[1], c = I[2];
  if (L2 < T2 * b) std::swap(a, c);
  const double nu = std::sqrt((L2 - T2 * a) * (c - b) / I.prod());
  const double m = (T2 * c - L2) * (b - a) / ((L2 - T2 * a) * (c - b));
  const double P = 2 * std::comp_ellint_1(std::sqrt(m)) / nu;
  const double s = std::remainder(t, P);
  const auto f = [&](const Vector3d& w) -> Vector3d { return -w.cross(I.cwiseProduct(w)).cwiseQuotient(I); };
  const int n = 4000;
  const double h = s / n;
  Vector3d w = omega0;
  for (int i = 0; i < n; ++i) {
    const Vector3d k1 = f(w), k2 = f(w + h / 2 * k1), k3 = f(w + h / 2 * k2), k4 = f(w + h * k3);
    w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return w;
//! wrong: at most a hundred thousand steps
  const long n = std::min(100000L, static_cast<long>(std::abs(t) / 0.01) + 1);
  const double h = t / static_cast<double>(n);
  auto f = [&](const Vector3d& v) -> Vector3d { return I.cwiseProduct(v).cross(v).cwiseQuotient(I); };
  Vector3d w = omega0;
  for (long k = 0; k < n; ++k) {
    const Vector3d a = f(w), b = f(w + h / 2 * a), c = f(w + h / 2 * b), d = f(w + h * c);
    w += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return w;
