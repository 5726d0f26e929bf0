#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/frame_derivatives.hpp>
Vector3d rotation_vector(const Matrix3d& E) {
//! right: by Eigen
  Eigen::Quaterniond q(E);
  if (q.w() < 0) q.coeffs() *= -1;
  const double s = q.vec().norm();
  if (s == 0) return Vector3d::Zero();
  return 2 * std::atan2(s, q.w()) / s * q.vec();
//! wrong: sign of the axis by the transposed matrix
  const double angle = std::acos(std::clamp((E.trace() - 1) / 2, -1.0, 1.0));
  if (angle < 1e-12) return Vector3d::Zero();
  Vector3d n(E(1, 2) - E(2, 1), E(2, 0) - E(0, 2), E(0, 1) - E(1, 0));
  return angle * n.normalized();
//! wrong: not divided by the sine
  const double angle = std::acos(std::clamp((E.trace() - 1) / 2, -1.0, 1.0));
  return angle * Vector3d(E(2, 1) - E(1, 2), E(0, 2) - E(2, 0), E(1, 0) - E(0, 1)) / 2;
//! wrong: asin loses angles above a right angle
  Vector3d s = Vector3d(E(2, 1) - E(1, 2), E(0, 2) - E(2, 0), E(1, 0) - E(0, 1)) / 2;
  double n = s.norm();
  if (n == 0) return Vector3d::Zero();
  return std::asin(std::min(n, 1.0)) / n * s;
//! wrong: to first order below a hundredth
  const Vector3d vee(E(2, 1) - E(1, 2), E(0, 2) - E(2, 0), E(1, 0) - E(0, 1));
  const double s = vee.norm() / 2;
  const double c = (E.trace() - 1) / 2;
  const double angle = std::atan2(s, c);
  if (angle < 0.01) return vee / 2;
  if (s > 1e-7) return vee / (2 * s) * angle;
  int k = 0;
  E.diagonal().maxCoeff(&k);
  Vector3d n = E.col(k) + Vector3d::Unit(k);
  return n.normalized() * angle;
//! wrong: arc cosine and the antisymmetric part
  const double angle = std::acos(std::clamp((E.trace() - 1) / 2, -1.0, 1.0));
  const Vector3d v(E(2, 1) - E(1, 2), E(0, 2) - E(2, 0), E(1, 0) - E(0, 1));
  if (v.norm() == 0) return Vector3d::Zero();
  return angle * v.normalized();
//! wrong: small angles to first order below a thousandth
  const Vector3d v(E(2, 1) - E(1, 2), E(0, 2) - E(2, 0), E(1, 0) - E(0, 1));
  if (v.norm() < 2e-3 && E.trace() > 0) return v / 2;
  const Eigen::AngleAxisd a(E);
  return a.angle() * a.axis();
//! right: quaternion by the largest of its numbers
  const double t = E.trace();
  const double d[4] = {t, E(0, 0), E(1, 1), E(2, 2)};
  const int k = static_cast<int>(std::max_element(d, d + 4) - d);
  double q[4];
  if (k == 0) {
    q[0] = 1 + t;
    q[1] = E(2, 1) - E(1, 2);
    q[2] = E(0, 2) - E(2, 0);
    q[3] = E(1, 0) - E(0, 1);
  } else {
    const int i = k - 1, j = (i + 1) % 3, l = (i + 2) % 3;
    q[0] = E(l, j) - E(j, l);
    q[1 + i] = 1 + 2 * E(i, i) - t;
    q[1 + j] = E(j, i) + E(i, j);
    q[1 + l] = E(l, i) + E(i, l);
  }
  Vector3d v(q[1], q[2], q[3]);
  double w = q[0];
  if (w < 0) {
    w = -w;
    v = -v;
  }
  const double n = v.norm();
  if (n == 0) return Vector3d::Zero();
  return v * (2 * std::atan2(n, w) / n);
