#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <rigid/euler_equations.hpp>
Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times) {
//! right: Taylor series of every step
static Vector3d taylor(const Vector3d& I, const Vector3d& start, double time) {
  const Vector3d factors((I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]);
  Vector3d w = start;
  double rest = time;
  while (rest != 0) {
    const double speed = w.cwiseAbs().maxCoeff() * std::max(1.0, factors.cwiseAbs().maxCoeff());
    double h = rest;
    if (speed * std::abs(h) > 0.25) h = std::copysign(0.25 / speed, rest);
    std::array<Vector3d, 25> a;
    a[0] = w;
    for (std::size_t n = 0; n + 1 < a.size(); ++n) {
      Vector3d sum = Vector3d::Zero();
      for (std::size_t j = 0; j <= n; ++j)
        for (int i = 0; i < 3; ++i) sum[i] += a[j][(i + 1) % 3] * a[n - j][(i + 2) % 3];
      a[n + 1] = h * factors.cwiseProduct(sum) / static_cast<double>(n + 1);
    }
    w = a[24];
    for (std::size_t n = 24; n-- > 0;) w += a[n];
    rest -= h;
  }
  return w;
}
Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times) {
  Matrix3Xd result(3, times.size());
  for (Eigen::Index k = 0; k < times.size(); ++k) result.col(k) = taylor(I, omega0, times[k]);
  return result;
}
//! right: Bulirsch-Stoer of the library
  using State = std::array<double, 3>;
  const double scale = omega0.norm();
  Matrix3Xd result = Matrix3Xd::Zero(3, times.size());
  if (scale == 0) return result;
  const auto system = [&](const State& w, State& rate, double) {
    rate[0] = w[1] * w[2] * (I[1] - I[2]) / I[0];
    rate[1] = w[2] * w[0] * (I[2] - I[0]) / I[1];
    rate[2] = w[0] * w[1] * (I[0] - I[1]) / I[2];
  };
  for (Eigen::Index k = 0; k < times.size(); ++k) {
    State w = {omega0[0] / scale, omega0[1] / scale, omega0[2] / scale};
    const double end = times[k] * scale;
    if (end != 0) {
      boost::numeric::odeint::bulirsch_stoer<State> stepper(1e-13, 1e-13);
      boost::numeric::odeint::integrate_adaptive(stepper, system, w, 0.0, end, end / 1000);
    }
    for (int i = 0; i < 3; ++i) result(i, k) = w[static_cast<std::size_t>(i)] * scale;
  }
  return result;
//! wrong: the times are taken for steps
static Vector3d rate(const Vector3d& I, const Vector3d& w) { return -w.cross(I.cwiseProduct(w)).cwiseQuotient(I); }
Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times) {
  Matrix3Xd result(3, times.size());
  Vector3d w = omega0;
  for (int k = 0; k < times.size(); ++k) {
    const int steps = 4000;
    const double h = times[k] / steps;
    for (int i = 0; i < steps; ++i) {
      const Vector3d k1 = rate(I, w), k2 = rate(I, w + h / 2 * k1), k3 = rate(I, w + h / 2 * k2),
                     k4 = rate(I, w + h * k3);
      w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    result.col(k) = w;
  }
  return result;
}
//! wrong: sign of Euler's equations
-static Vector3d rate(const Vector3d& I, const Vector3d& w) { return -w.cross(I.cwiseProduct(w)).cwiseQuotient(I); }
+static Vector3d rate(const Vector3d& I, const Vector3d& w) { return w.cross(I.cwiseProduct(w)).cwiseQuotient(I); }
@@
-  Vector3d w = omega0;
   for (int k = 0; k < times.size(); ++k) {
+    Vector3d w = omega0;
//! wrong: the last time is looked up even if there is none
+  const double end = times.maxCoeff();
   Matrix3Xd result(3, times.size());
-  Vector3d w = omega0;
   for (int k = 0; k < times.size(); ++k) {
-    const int steps = 4000;
+    Vector3d w = omega0;
+    const int steps = times[k] == end ? 20000 : 19000;
//! wrong: whole steps only, the remainder is dropped
-  Vector3d w = omega0;
   for (int k = 0; k < times.size(); ++k) {
-    const int steps = 4000;
-    const double h = times[k] / steps;
+    const double h = times[k] < 0 ? -0.01 : 0.01;
+    const int steps = times[k] / h;
+    Vector3d w = omega0;
//! wrong: the times are taken for sorted
+  double t = 0;
   for (int k = 0; k < times.size(); ++k) {
-    const int steps = 4000;
-    const double h = times[k] / steps;
-    for (int i = 0; i < steps; ++i) {
+    while (t < times[k]) {
+      const double h = std::min(0.0005, times[k] - t);
@@
       w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
+      t += h;
//! wrong: one long step of Euler's method
  Matrix3Xd result(3, times.size());
  for (int k = 0; k < times.size(); ++k) {
    const Vector3d L = I.cwiseProduct(omega0);
    result.col(k) = omega0 - omega0.cross(L).cwiseQuotient(I) * times[k];
  }
  return result;
//! wrong: negative times are not reached
static Vector3d rate(const Vector3d& I, const Vector3d& w) { return -w.cross(I.cwiseProduct(w)).cwiseQuotient(I); }
Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times) {
  Matrix3Xd result(3, times.size());
  for (int k = 0; k < times.size(); ++k) {
    Vector3d w = omega0;
    const double h = 0.001 / (1 + omega0.norm());
    double t = 0;
    while (t < times[k]) {
      const double s = std::min(h, times[k] - t);
      const Vector3d k1 = rate(I, w), k2 = rate(I, w + s / 2 * k1), k3 = rate(I, w + s / 2 * k2),
                     k4 = rate(I, w + s * k3);
      w += s / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      t += s;
    }
    result.col(k) = w;
  }
  return result;
}
//! wrong: the solution of the symmetric top for every body
  const double Omega = omega0[2] * (I[2] - I[0]) / I[0];
  Matrix3Xd result(3, times.size());
  for (int k = 0; k < times.size(); ++k)
    result.col(k) = Eigen::AngleAxisd(Omega * times[k], Vector3d::UnitZ()) * omega0;
  return result;
//! wrong: a hundred midpoint steps for every time
  Matrix3Xd out(3, times.size());
  for (int k = 0; k < times.size(); ++k) {
    Vector3d w = omega0;
    const double h = times[k] / 100;
    for (int i = 0; i < 100; ++i) {
      const Vector3d a = I.cwiseProduct(w).cross(w).cwiseQuotient(I);
      const Vector3d mid = w + a * h / 2;
      w += h * I.cwiseProduct(mid).cross(mid).cwiseQuotient(I);
    }
    out.col(k) = w;
  }
  return out;
//! right: steps halved until two rules agree
struct Stepper {
  Vector3d I;
  Vector3d rate(const Vector3d& w) const { return I.cwiseProduct(w).cross(w).cwiseQuotient(I); }
  Vector3d rk4(const Vector3d& w, double h) const {
    const Vector3d a = rate(w), b = rate(w + h / 2 * a), c = rate(w + h / 2 * b), d = rate(w + h * c);
    return w + h / 6 * (a + 2 * b + 2 * c + d);
  }
  Vector3d to(Vector3d w, double t) const {
    double done = 0, h = t / 64;
    const double tol = 1e-13 * w.norm();
    int guard = 0;
    while (std::abs(done) < std::abs(t) && ++guard < 2000000) {
      if (std::abs(h) > std::abs(t - done)) h = t - done;
      const Vector3d one = rk4(w, h), two = rk4(rk4(w, h / 2), h / 2);
      const double e = (one - two).norm();
      if (e <= tol || std::abs(h) < 1e-9 * std::abs(t)) {
        done += h;
        w = two + (two - one) / 15;
        if (e < tol / 64) h *= 1.9;
      } else {
        h /= 2;
      }
    }
    return w;
  }
};
Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times) {
  Matrix3Xd out(3, times.size());
  const Stepper s{I};
  for (Eigen::Index k = 0; k < times.size(); ++k) out.col(k) = times[k] == 0 ? omega0 : s.to(omega0, times[k]);
  return out;
}
//! wrong: 200 steps of fourth order for every time
struct Stepper {
  Vector3d I;
  Vector3d rate(const Vector3d& w) const { return I.cwiseProduct(w).cross(w).cwiseQuotient(I); }
  Vector3d rk4(const Vector3d& w, double h) const {
    const Vector3d a = rate(w), b = rate(w + h / 2 * a), c = rate(w + h / 2 * b), d = rate(w + h * c);
    return w + h / 6 * (a + 2 * b + 2 * c + d);
  }
  Vector3d to(Vector3d w, double t) const {
    for (int i = 0; i < 200; ++i) w = rk4(w, t / 200);
    return w;
  }
};
Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times) {
  Matrix3Xd out(3, times.size());
  const Stepper s{I};
  for (Eigen::Index k = 0; k < times.size(); ++k) out.col(k) = times[k] == 0 ? omega0 : s.to(omega0, times[k]);
  return out;
}
