#include <boost/math/special_functions/ellint_1.hpp>
#include <algorithm>
#include <cmath>
#include <utility>
#include <rigid/free_tops.hpp>
double first_flip(const Vector3d& I, const Vector3d& omega0) {
//! wrong: last step not shortened: the step is too coarse
  const auto f = [&](const Vector3d& w) -> Vector3d { return -w.cross(I.cwiseProduct(w)).cwiseQuotient(I); };
  Vector3d w = omega0;
  double t = 0;
  const double h = 0.01 / omega0.norm();
  while (w[1] * omega0[1] > 0) {
    const Vector3d a = f(w), b = f(w + h / 2 * a), c = f(w + h / 2 * b), d = f(w + h * c);
    w += h / 6 * (a + 2 * b + 2 * c + d);
    t += h;
  }
  return t;
//! wrong: quarter of the period less the phase, whatever the sense
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  double a = I[0], b = I[1], c = I[2];
  if (L2 < T2 * b) std::swap(a, c);
  const double nu = std::sqrt((L2 - T2 * a) * (c - b) / I.prod());
  const double m = (T2 * c - L2) * (b - a) / ((L2 - T2 * a) * (c - b));
  const double s = std::abs(omega0[1]) / std::sqrt((T2 * c - L2) / (b * (c - b)));
  return (std::comp_ellint_1(std::sqrt(m)) - std::ellint_1(std::sqrt(m), std::asin(std::min(1.0, s)))) / nu;
//! right: elliptic integral from the start
  double a = I[0], b = I[1], c = I[2];
  Vector3d w = omega0;
  if (a * (b - a) * w[0] * w[0] > c * (c - b) * w[2] * w[2]) {
    std::swap(a, c);
    std::swap(w[0], w[2]);
    w = -w;
    a = -a; b = -b; c = -c;
    // signs: with all moments negative the equations run with the same rates
    a = -a; b = -b; c = -c;
    w = -w;
  }
  const double x = std::abs(b * (b - a) * w[1] * w[1] + c * (c - a) * w[2] * w[2]);
  const double y = std::abs(a * (c - a) * w[0] * w[0] + b * (c - b) * w[1] * w[1]);
  const double nu = std::sqrt(x * std::abs(c - b) / (a * b * c));
  const double m = y * std::abs(b - a) / (x * std::abs(c - b));
  const double u2 = std::sqrt(y / (b * std::abs(c - b)));
  const double ratio = std::min(1.0, std::abs(omega0[1]) / u2);
  const double p = std::sqrt(a * std::abs(c - a) / y) * std::abs(w[0]);
  const double am = std::atan2(ratio, p);
  const double F = std::ellint_1(std::sqrt(m), am), K = std::comp_ellint_1(std::sqrt(m));
  const double rate = (I[2] - I[0]) * omega0[2] * omega0[0];
  const bool grows = rate * omega0[1] > 0;
  return grows ? (2 * K - F) / nu : F / nu;
//! wrong: exponential growth up to the flip
  const double sigma = std::abs(omega0[1]) * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2]));
  return std::log(2 * std::abs(omega0[1]) / std::hypot(omega0[0], omega0[2]) + 1) / sigma;
//! wrong: the parameter as modulus
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  double I1 = I[0], I2 = I[1], I3 = I[2], w1 = omega0[0];
  if (L2 < T2 * I2) { std::swap(I1, I3); w1 = omega0[2]; }
  const double rate = std::sqrt((L2 - T2 * I1) * (I3 - I2) / (I1 * I2 * I3));
  const double m = (I2 - I1) * (T2 * I3 - L2) / ((I3 - I2) * (L2 - T2 * I1));
  const double a1 = std::sqrt((T2 * I3 - L2) / (I1 * (I3 - I1))), a2 = std::sqrt((T2 * I3 - L2) / (I2 * (I3 - I2)));
  const double phi = std::atan2(std::abs(omega0[1]) / a2, std::abs(w1) / a1);
  const double F = boost::math::ellint_1(m, phi), K = boost::math::ellint_1(m);
  return (omega0.prod() > 0 ? 2 * K - F : F) / rate;
