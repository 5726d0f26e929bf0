#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/inertia_tensor.hpp>
double largest_angle_between_L_and_omega(const Vector3d& I) {
//! right: search over the tilt
  const double a = I.minCoeff(), c = I.maxCoeff();
  const auto f = [&](double x) {
    const Vector2d w(std::cos(x), std::sin(x)), L(a * w[0], c * w[1]);
    return std::atan2(std::abs(w[0] * L[1] - w[1] * L[0]), w.dot(L));
  };
  double lo = 0, hi = std::numbers::pi / 2;
  for (int i = 0; i < 200; ++i) {
    const double m1 = lo + (hi - lo) / 3, m2 = hi - (hi - lo) / 3;
    (f(m1) < f(m2) ? lo : hi) = f(m1) < f(m2) ? m1 : m2;
  }
  return f((lo + hi) / 2);
//! wrong: moments not sorted, and a sine that is twice too large
  return std::asin(std::min(1.0, std::abs(I[2] - I[0]) / (I[2] + I[0]) * 2));
//! wrong: twice the tangent
  Vector3d s = I;
  std::sort(s.data(), s.data() + 3);
  return std::atan((s(2) - s(0)) / std::sqrt(s(0) * s(2)));
//! wrong: middle moment for the smallest
-  return std::atan((s(2) - s(0)) / std::sqrt(s(0) * s(2)));
+  return std::asin((s[2] - s[1]) / (s[2] + s[1]));
//! wrong: directions in steps of a degree
  double best = 0;
  const double step = M_PI / 180;
  for (int i = 0; i <= 90; ++i) {
    for (int j = 0; j <= 90; ++j) {
      const Vector3d w(std::sin(i * step) * std::cos(j * step), std::sin(i * step) * std::sin(j * step), std::cos(i * step));
      const Vector3d L = I.cwiseProduct(w);
      best = std::max(best, std::atan2(w.cross(L).norm(), w.dot(L)));
    }
  }
  return best;
