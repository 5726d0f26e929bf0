#include <cmath>
#include <complex>
#include <rigid/heavy_top.hpp>
double nutation_frequency(double I1, double mgl, double theta, double rate) {
//! right: two squares
  const double c = std::cos(theta), s = std::sin(theta), b = c * rate + mgl / (I1 * rate);
  return std::hypot(rate * s, b - 2 * rate * c);
//! right: the slope by a difference in long double
static long double pull(long double I1, long double mgl, long double t, long double a, long double b) {
  const long double rate = (a - b * std::cos(t)) / (std::sin(t) * std::sin(t));
  return std::sin(t) * (std::cos(t) * rate * rate - b * rate + mgl / I1);
}
double nutation_frequency(double I1, double mgl, double theta, double rate) {
  const long double t = theta, b = std::cos(t) * rate + mgl / ((long double)I1 * rate);
  const long double a = rate * std::sin(t) * std::sin(t) + b * std::cos(t), h = 2e-4L * std::sin(t);
  const auto slope = [&](long double step) {
    return (pull(I1, mgl, t + step, a, b) - pull(I1, mgl, t - step, a, b)) / (2 * step);
  };
  return static_cast<double>(std::sqrt(-(4 * slope(h / 2) - slope(h)) / 3));
}
//! wrong: a bead on a hoop that a motor turns
  (void)I1, (void)mgl;
  return std::abs(rate * std::sin(theta));
//! wrong: the momentum over the moment
  return std::abs(rate * std::cos(theta) + mgl / (I1 * rate));
//! wrong: the mixed term without its two
  const double w = mgl / I1;
  return std::sqrt(rate * rate - w * std::cos(theta) + w * w / (rate * rate));
//! wrong: sine for cosine
  const double w = mgl / I1;
  return std::sqrt(std::abs(rate * rate - 2 * w * std::sin(theta) + w * w / (rate * rate)));
//! wrong: a term under the root forgotten
  const double s = std::sin(theta), c = std::cos(theta);
  (void)s;
  const double a = mgl / (I1 * rate);
  return std::sqrt(a * a - 2 * c * mgl / I1);
//! right: slope of the effective potential by a complex step
  const double c = std::cos(theta), s = std::sin(theta);
  const double ppsi_over = (mgl / rate + I1 * rate * c), pphi = I1 * rate * s * s + ppsi_over * c;
  const auto slope = [&](std::complex<double> x) {
    const std::complex<double> k = std::cos(x), q = std::sin(x), d = pphi - ppsi_over * k;
    return d * ppsi_over / (I1 * q) - d * d * k / (I1 * q * q * q) - mgl * q;
  };
  const double h = 1e-30;
  return std::sqrt(slope({theta, h}).imag() / h / I1);
//! wrong: frequency of a fast top, with the sign of the rate
  return (I1 * std::cos(theta) * rate + mgl / rate) / I1;
