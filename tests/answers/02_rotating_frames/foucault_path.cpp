#include <cmath>
#include <complex>
#include <rigid/rotating_frames.hpp>
Vector2d foucault_path(const Vector2d& start, double length, double g, double latitude, double earth_rate, double t) {
//! wrong: turns the other way, and starts along the line
  const double w = std::sqrt(g / length), p = earth_rate * std::sin(latitude);
  const double a = p * t;
  const Eigen::Vector2d s = start * std::cos(w * t);
  return {std::cos(a) * s.x() - std::sin(a) * s.y(), std::sin(a) * s.x() + std::cos(a) * s.y()};
//! right: complex numbers
  using C = std::complex<double>;
  const double p = earth_rate * std::sin(latitude), w0 = std::sqrt(g / length);
  const double w = std::sqrt(w0 * w0 + p * p);
  const C z0(start.x(), start.y());
  const C i(0, 1);
  const C z = z0 * std::exp(-i * p * t) * (std::cos(w * t) + i * p / w * std::sin(w * t));
  return {z.real(), z.imag()};
//! right: equation of motion in small steps of complex numbers
  using C = std::complex<double>;
  const double w2 = g / length, O = earth_rate * std::sin(latitude);
  C z(start[0], start[1]), u = 0;
  const int n = 1 + static_cast<int>(t * std::sqrt(w2) * 60);
  const double h = t / n;
  const auto acc = [&](C x, C y) { return -w2 * x - C(0, 2 * O) * y; };
  for (int k = 0; k < n; ++k) {
    const C a1 = acc(z, u), u2 = u + h / 2 * a1, a2 = acc(z + h / 2 * u, u2), u3 = u + h / 2 * a2, a3 = acc(z + h / 2 * u2, u3),
            u4 = u + h * a3, a4 = acc(z + h * u3, u4);
    z += h / 6 * (u + 2. * u2 + 2. * u3 + u4);
    u += h / 6 * (a1 + 2. * a2 + 2. * a3 + a4);
  }
  return {z.real(), z.imag()};
