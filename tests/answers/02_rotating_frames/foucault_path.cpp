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
