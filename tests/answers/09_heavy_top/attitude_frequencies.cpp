#include <algorithm>
#include <cmath>
#include <rigid/heavy_top.hpp>
Vector3d attitude_frequencies(const Vector3d& I, double orbital_rate) {
//! right: the quadratic equation, its roots from sum and product
  const double a = I[0] * I[1], g = I[0] + I[1] - I[2], k1 = I[2] - I[1], k2 = 4 * (I[2] - I[0]);
  const double b = k1 * I[1] + k2 * I[0] + g * g, c = k1 * k2;
  const double large = (b + std::sqrt(b * b - 4 * a * c)) / (2 * a), small = c / (a * large);
  return orbital_rate * Vector3d(std::sqrt(3 * (I[1] - I[0]) / I[2]), std::sqrt(small), std::sqrt(large));
//! wrong: the moment about the normal in the plane forgotten
-  return orbital_rate * Vector3d(std::sqrt(3 * (I[1] - I[0]) / I[2]), std::sqrt(small), std::sqrt(large));
+  return orbital_rate * Vector3d(std::sqrt(3 * (I[1] - I[0]) / I[0]), std::sqrt(small), std::sqrt(large));
//! wrong: no torque of gravity across the plane
-  const double a = I[0] * I[1], g = I[0] + I[1] - I[2], k1 = I[2] - I[1], k2 = 4 * (I[2] - I[0]);
+  const double a = I[0] * I[1], g = I[0] + I[1] - I[2], k1 = I[2] - I[1], k2 = I[2] - I[0];
//! wrong: radial and forward exchanged
  const double a = I[0] * I[1], g = I[0] + I[1] - I[2], k1 = I[2] - I[0], k2 = 4 * (I[2] - I[1]);
  const double b = k1 * I[0] + k2 * I[1] + g * g, c = k1 * k2;
  const double large = (b + std::sqrt(b * b - 4 * a * c)) / (2 * a), small = c / (a * large);
  return orbital_rate * Vector3d(std::sqrt(3 * (I[1] - I[0]) / I[2]), std::sqrt(small), std::sqrt(large));
//! wrong: two pendulums across the plane
  const double a = 4 * (I[2] - I[0]) / I[1], b = (I[2] - I[1]) / I[0];
  const double roll = std::sqrt(std::abs(a)), yaw = std::sqrt(std::abs(b));
  return orbital_rate * Vector3d(std::sqrt(3 * (I[1] - I[0]) / I[2]), std::fmin(roll, yaw), std::fmax(roll, yaw));
//! wrong: the sign of the coupling
  const double a = I[0] * I[1], g = I[0] + I[1] - I[2], k1 = I[2] - I[1], k2 = 4 * (I[2] - I[0]);
  const double b = k1 * I[1] + k2 * I[0] - g * g, c = k1 * k2;
  const double root = std::sqrt(std::abs(b * b - 4 * a * c));
  return orbital_rate * Vector3d(std::sqrt(3 * (I[1] - I[0]) / I[2]), std::sqrt(std::abs(b - root) / (2 * a)),
                                 std::sqrt(std::abs(b + root) / (2 * a)));
//! wrong: the torque without its three
  const double kp = (I[1] - I[0]) / I[2], k1 = (I[2] - I[1]) / I[0], k2 = (I[2] - I[0]) / I[1];
  const double half = 0.5 * (k1 + 2 * k2 + (1 - k1) * (1 - k2));
  const double product = 2 * k1 * k2;
  const double root = std::sqrt(std::max(0.0, half * half - product));
  return orbital_rate * Vector3d(std::sqrt(kp), std::sqrt(product / (half + root)), std::sqrt(half + root));
