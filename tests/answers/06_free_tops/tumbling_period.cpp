#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <utility>
#include <rigid/free_tops.hpp>
double tumbling_period(const Vector3d& I, const Vector3d& omega0) {
//! right: arithmetic-geometric mean
static double mean(double a, double b) {
  for (int i = 0; i < 60 && a != b; ++i) {
    const double next = (a + b) / 2;
    b = std::sqrt(a * b);
    a = next;
  }
  return a;
}
double tumbling_period(const Vector3d& I, const Vector3d& omega0) {
  double I1 = I[0], I2 = I[1], I3 = I[2];
  Vector3d s = omega0.cwiseAbs2();
  double excess = I1 * (I1 - I2) * s[0] + I3 * (I3 - I2) * s[2];
  if (excess < 0) {
    std::swap(I1, I3);
    std::swap(s[0], s[2]);
  }
  const double above = I2 * (I2 - I1) * s[1] + I3 * (I3 - I1) * s[2];
  const double nu = std::sqrt(above * (I3 - I2) / (I1 * I2 * I3));
  return 2 * M_PI / mean(1, std::sqrt((I3 - I1) * excess / (above * (I3 - I2)))) / nu;
}
//! wrong: no period for a spin about one axis alone
-  for (int i = 0; i < 60 && a != b; ++i) {
+  while (std::abs(a - b) > 1e-15 * a) {
@@
 double tumbling_period(const Vector3d& I, const Vector3d& omega0) {
+  if (omega0[0] == 0 && omega0[1] == 0) return 0;
+  if (omega0[1] == 0 && omega0[2] == 0) return 0;
@@
-  double excess = I1 * (I1 - I2) * s[0] + I3 * (I3 - I2) * s[2];
-  if (excess < 0) {
+  if (I1 * (I1 - I2) * s[0] + I3 * (I3 - I2) * s[2] < 0) {
@@
+  const double excess = I1 * (I1 - I2) * s[0] + I3 * (I3 - I2) * s[2];
   const double above = I2 * (I2 - I1) * s[1] + I3 * (I3 - I1) * s[2];
//! right: the formula of the contract with the standard library
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  double I1 = I[0], I2 = I[1], I3 = I[2];
  if (L2 < T2 * I2) std::swap(I1, I3);
  const double nu = std::sqrt((L2 - T2 * I1) * (I3 - I2) / (I1 * I2 * I3));
  const double m = (T2 * I3 - L2) * (I2 - I1) / ((L2 - T2 * I1) * (I3 - I2));
  return 4 * std::comp_ellint_1(std::sqrt(std::max(0.0, m))) / nu;
//! wrong: the parameter taken for the modulus
-  return 4 * std::comp_ellint_1(std::sqrt(std::max(0.0, m))) / nu;
+  return 4 * boost::math::ellint_1(m) / nu;
//! wrong: half the period
-  return 4 * std::comp_ellint_1(std::sqrt(std::max(0.0, m))) / nu;
+  return 2 * boost::math::ellint_1(std::sqrt(m)) / nu;
//! right: differences summed first, Legendre's integral of the library
  double a = I[0], b = I[1], c = I[2], x = omega0[0], y = omega0[1], z = omega0[2];
  if (a * (b - a) * x * x > c * (c - b) * z * z) {
    std::swap(a, c);
    std::swap(x, z);
  }
  const double below = a * (c - a) * x * x + b * (c - b) * y * y;
  const double above = b * (b - a) * y * y + c * (c - a) * z * z;
  const double k = std::sqrt(below * (b - a) / (above * (c - b)));
  return 4 * boost::math::ellint_1(k) / std::sqrt(above * (c - b) / (a * b * c));
//! wrong: only motion about axis 3
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  const double nu = std::sqrt((L2 - T2 * I[0]) * (I[2] - I[1]) / (I[0] * I[1] * I[2]));
  const double m = (T2 * I[2] - L2) * (I[1] - I[0]) / ((L2 - T2 * I[0]) * (I[2] - I[1]));
  return 4 * boost::math::ellint_1(std::sqrt(m)) / nu;
//! wrong: the period of a small wobble
  double I1 = I[0], I2 = I[1], I3 = I[2], spin = omega0[2];
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  if (L2 < T2 * I2) {
    std::swap(I1, I3);
    spin = omega0[0];
  }
  return 2 * M_PI / (std::abs(spin) * std::sqrt((I3 - I1) * (I3 - I2) / (I1 * I2)));
//! wrong: energy in place of twice the energy
  const double T = 0.5 * I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  double I1 = I[0], I2 = I[1], I3 = I[2];
  if (L2 < T * I2) std::swap(I1, I3);
  const double nu = std::sqrt((L2 - T * I1) * (I3 - I2) / (I1 * I2 * I3));
  const double m = (T * I3 - L2) * (I2 - I1) / ((L2 - T * I1) * (I3 - I2));
  return 4 * boost::math::ellint_1(std::sqrt(m)) / nu;
//! wrong: the parameter where the modulus belongs, and half a period
  const double T2 = I.cwiseProduct(omega0).dot(omega0), L2 = I.cwiseProduct(omega0).squaredNorm();
  double a = I[0], c = I[2];
  if (L2 < T2 * I[1]) std::swap(a, c);
  const double nu = std::sqrt((L2 - T2 * a) * (c - I[1]) / (I[0] * I[1] * I[2]));
  const double m = (T2 * c - L2) * (I[1] - a) / ((L2 - T2 * a) * (c - I[1]));
  return 2 * std::comp_ellint_1(m) / nu;
