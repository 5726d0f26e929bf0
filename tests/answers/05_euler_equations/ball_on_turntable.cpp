#include <cmath>
#include <rigid/euler_equations.hpp>
Vector2d ball_on_turntable(double k, double table_rate, const Vector2d& start, const Vector2d& velocity, double t) {
//! right: a circle about its centre
  const double w = table_rate * k / (1 + k);
  if (std::abs(w * t) < 1e-6) return start + velocity * t + 0.5 * t * t * w * Vector2d(-velocity[1], velocity[0]);
  const Vector2d center = start + Vector2d(-velocity[1], velocity[0]) / w;
  return center + Eigen::Rotation2Dd(w * t) * (start - center);
//! wrong: centre of the circle on the other side
  const double w = table_rate * k / (1 + k);
  if (w == 0) return start + velocity * t;
  const Vector2d center = start + Vector2d(velocity[1], -velocity[0]) / w;
  return center + Eigen::Rotation2Dd(w * t) * (start - center);
//! right: small steps of fourth order
  const double w = table_rate / (1 + 1 / k);
  const int n = 2000;
  const double h = t / n;
  Vector2d r = start, v = velocity;
  auto rate = [&](const Vector2d& u) { return Vector2d(-w * u[1], w * u[0]); };
  for (int i = 0; i < n; ++i) {
    const Vector2d a1 = rate(v), a2 = rate(v + h / 2 * a1), a3 = rate(v + h / 2 * a2), a4 = rate(v + h * a3);
    r += h * v + h * h / 6 * (a1 + a2 + a3);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return r;
//! wrong: the velocity of the table differentiated at a fixed place
  (void)k;
  (void)table_rate;
  return start + velocity * t;
//! wrong: the sign of the contact force in the torque
  const double w = table_rate * k / (k - 1), c = std::cos(w * t), s = std::sin(w * t);
  if (w == 0) return start + velocity * t;
  return {start[0] + (s * velocity[0] - (1 - c) * velocity[1]) / w,
          start[1] + ((1 - c) * velocity[0] + s * velocity[1]) / w};
//! wrong: the rate of the table
-  const double w = table_rate * k / (k - 1), c = std::cos(w * t), s = std::sin(w * t);
+  const double w = table_rate, c = std::cos(w * t), s = std::sin(w * t);
//! wrong: a solid ball whatever k is, and the start not added
  const double n = 2.0 / 7 * table_rate;
  if (n == 0) return start + velocity * t;
  const double s = std::sin(n * t) / n, c = (1 - std::cos(n * t)) / n;
  return {s * velocity[0] - c * velocity[1], c * velocity[0] + s * velocity[1]};
