#include <cmath>
#include <rigid/euler_equations.hpp>
Matrix3d free_attitude(const Vector3d& I, const Vector3d& omega0, double t) {
//! right: composed splitting steps of fourth order
  const double l0 = 1 / (2 - std::cbrt(2.0)), l1 = 1 - 2 * l0;
  const int n = 12000;
  Vector3d L = I.cwiseProduct(omega0);
  Matrix3d A = Matrix3d::Identity();
  const auto turn = [&](int i, double dt) {
    const double a = dt * L[i] / I[i];
    L = Eigen::AngleAxisd(-a, Vector3d::Unit(i)) * L;
    A = A * Eigen::AngleAxisd(a, Vector3d::Unit(i)).toRotationMatrix();
  };
  for (int k = 0; k < n; ++k)
    for (const double c : {l0, l1, l0}) {
      const double h = c * t / n;
      turn(0, h / 2);
      turn(1, h / 2);
      turn(2, h);
      turn(1, h / 2);
      turn(0, h / 2);
    }
  return A;
//! wrong: 150 steps for every time
-  const int n = 12000;
+  const int n = 150;
//! wrong: turns multiplied from the left, and steps of first order
  const int n = 100 + 1000 * std::abs(t);
  const double h = t / n;
  Matrix3d A = Matrix3d::Identity();
  Vector3d w = omega0;
  for (int k = 0; k < n; ++k) {
    if (w.norm() > 0) A = Eigen::AngleAxisd(w.norm() * h, w.normalized()).toRotationMatrix() * A;
    const Vector3d a((I[1] - I[2]) * w[1] * w[2] / I[0], (I[2] - I[0]) * w[2] * w[0] / I[1],
                     (I[0] - I[1]) * w[0] * w[1] / I[2]);
    w += h * a;
  }
  return A;
//! wrong: rate of the quaternion without a half
  using V7 = Eigen::Matrix<double, 7, 1>;
  auto rate = [&](const V7& y) {
    const Vector3d w = y.tail<3>();
    const Eigen::Quaterniond q(y[0], y[1], y[2], y[3]), wq(0, w[0], w[1], w[2]);
    const Eigen::Quaterniond d = q * wq;
    V7 out;
    out << d.w(), d.x(), d.y(), d.z(), I.cwiseProduct(w).cross(w).cwiseQuotient(I);
    return out;
  };
  V7 y;
  y << 1, 0, 0, 0, omega0;
  const int n = 6000;
  const double h = t / n;
  for (int k = 0; k < n; ++k) {
    const V7 k1 = rate(y), k2 = rate(y + h / 2 * k1), k3 = rate(y + h / 2 * k2), k4 = rate(y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return Eigen::Quaterniond(y[0], y[1], y[2], y[3]).normalized().toRotationMatrix();
