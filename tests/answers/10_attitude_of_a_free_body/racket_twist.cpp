#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
//! right: small steps in time, the last one cut
struct Throw {
  Vector3d w;
  double round, twist;
};
static Throw rates(const Vector3d& I, const Throw& s) {
  const Vector3d L = I.cwiseProduct(s.w);
  const double way = L.norm() * (L[1] * s.w[1] + L[2] * s.w[2]) / (L[1] * L[1] + L[2] * L[2]);
  return {L.cross(s.w).cwiseQuotient(I), way, s.w[0] - way * L[0] / L.norm()};
}
static Throw moved(const Throw& s, double h, const Throw& k) {
  return {s.w + h * k.w, s.round + h * k.round, s.twist + h * k.twist};
}
static Throw step(const Vector3d& I, const Throw& s, double h) {
  const Throw a = rates(I, s), b = rates(I, moved(s, h / 2, a)), c = rates(I, moved(s, h / 2, b));
  return moved(moved(moved(moved(s, h / 6, a), h / 3, b), h / 3, c), h / 6, rates(I, moved(s, h, c)));
}
double racket_twist(const Vector3d& I, const Vector3d& omega0) {
  Throw now{omega0, 0, 0};
  const double h = 1e-3 / rates(I, now).round;
  while (now.round < 2 * M_PI) now = step(I, now, h);
  for (int i = 0; i < 8; ++i) now = step(I, now, (2 * M_PI - now.round) / rates(I, now).round);
  return now.twist;
}
//! right: two angles, the one over the other
// y = (eta, chi, twist) over the angle of the handle
static Vector3d slope(const Vector3d& I, const Vector3d& y) {
  const double b = std::pow(std::cos(y[1]), 2) / I[1] + std::pow(std::sin(y[1]), 2) / I[2];
  const double d_eta = std::sin(y[0]) * std::sin(y[1]) * std::cos(y[1]) * (1 / I[2] - 1 / I[1]);
  const double d_twist = std::cos(y[0]) * (1 / I[0] - b);
  return Vector3d(-d_eta, -d_twist, d_twist) / b;
}
double racket_twist(const Vector3d& I, const Vector3d& omega0) {
  const Vector3d l = I.cwiseProduct(omega0).normalized();
  Vector3d y(std::atan2(std::hypot(l[1], l[2]), l[0]), std::atan2(l[2], l[1]), 0);
  const int n = 4000;
  const double h = 2 * M_PI / n;
  for (int i = 0; i < n; ++i) {
    const Vector3d a = slope(I, y), b = slope(I, y + h / 2 * a), c = slope(I, y + h / 2 * b);
    y += h / 6 * (a + 2 * b + 2 * c + slope(I, y + h * c));
  }
  return y[2];
}
//! wrong: half a turn, always
double racket_twist(const Vector3d&, const Vector3d& omega0) { return omega0[0] < 0 ? -M_PI : M_PI; }
//! wrong: the time of a turn from the energy
static Vector3d free(const Vector3d& I, const Vector3d& w) { return I.cwiseProduct(w).cross(w).cwiseQuotient(I); }
double racket_twist(const Vector3d& I, const Vector3d& omega0) {
  Vector3d w = omega0;
  const double time = 2 * M_PI * I.cwiseProduct(omega0).norm() / I.dot(omega0.cwiseAbs2());
  const int n = 20000;
  double twist = 0;
  for (int i = 0; i < n; ++i) {
    const Vector3d L = I.cwiseProduct(w);
    const double way = L.norm() * (L[1] * w[1] + L[2] * w[2]) / (L[1] * L[1] + L[2] * L[2]);
    twist += time / n * (w[0] - way * L[0] / L.norm());
    w += time / n * free(I, w + time / n / 2 * free(I, w));
  }
  return twist;
}
//! wrong: azimuth of L at the end, without whole turns
static Vector3d free(const Vector3d& I, const Vector3d& w) { return I.cwiseProduct(w).cross(w).cwiseQuotient(I); }
double racket_twist(const Vector3d& I, const Vector3d& omega0) {
  Vector3d w = omega0;
  double round = 0;
  const double h = 1e-4 / omega0.norm();
  while (round < 2 * M_PI) {
    const Vector3d L = I.cwiseProduct(w);
    round += h * L.norm() * (L[1] * w[1] + L[2] * w[2]) / (L[1] * L[1] + L[2] * L[2]);
    w += h * free(I, w + h / 2 * free(I, w));
  }
  return std::atan2(I[2] * w[2], I[1] * w[1]) - std::atan2(I[2] * omega0[2], I[1] * omega0[1]);
}
//! wrong: all of omega_1 taken for the twist
-  double round = 0;
+  double round = 0, twist = 0;
@@
     round += h * L.norm() * (L[1] * w[1] + L[2] * w[2]) / (L[1] * L[1] + L[2] * L[2]);
+    twist += h * w[0];
@@
-  return std::atan2(I[2] * w[2], I[1] * w[1]) - std::atan2(I[2] * omega0[2], I[1] * omega0[1]);
+  return twist;
//! wrong: for the time of a turn about the middle axis
double racket_twist(const Vector3d& I, const Vector3d& omega0) {
  const double L = I.cwiseProduct(omega0).norm();
  const double round = 2 * M_PI * I[1] / L;
  const int n = 20000;
  const double h = round / n;
  Eigen::Vector4d y;
  y << omega0, 0;
  auto f = [&](const Eigen::Vector4d& v) {
    const Vector3d w = v.head<3>(), l = I.cwiseProduct(w);
    const double azimuth = L * (l[1] * w[1] + l[2] * w[2]) / (l[1] * l[1] + l[2] * l[2]);
    Eigen::Vector4d d;
    d << l.cross(w).cwiseQuotient(I), w[0] - azimuth * l[0] / L;
    return d;
  };
  for (int k = 0; k < n; ++k) {
    const Eigen::Vector4d a = f(y), b = f(y + h / 2 * a), c = f(y + h / 2 * b), d = f(y + h * c);
    y += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return y[3];
}
