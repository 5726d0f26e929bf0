#include <rigid/frame_derivatives.hpp>
Vector3d angular_velocity_from_three_points(const Matrix3d& r, const Matrix3d& v) {
//! wrong: mean of two sides
  Vector3d sum = Vector3d::Zero();
  for (int k = 1; k < 3; ++k) {
    const Vector3d d = r.col(k) - r.col(0), u = v.col(k) - v.col(0);
    sum += d.cross(u) / d.squaredNorm();
  }
  return sum / 2;
//! right: least squares
  const Vector3d a = r.col(1) - r.col(0), b = r.col(2) - r.col(0);
  Eigen::Matrix<double, 6, 3> m;
  auto skew = [](const Vector3d& x) -> Matrix3d { Matrix3d s; s << 0, x.z(), -x.y(), -x.z(), 0, x.x(), x.y(), -x.x(), 0; return s; };
  m << skew(a), skew(b);
  Eigen::Matrix<double, 6, 1> rhs;
  rhs << v.col(1) - v.col(0), v.col(2) - v.col(0);
  return m.colPivHouseholderQr().solve(rhs);
//! wrong: as if the origin were at rest
  const Matrix3d W = v * r.inverse();
  return Vector3d(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1)) / 2;
//! wrong: momentum over the sum of the squares
  const Vector3d c = r.rowwise().mean(), u = v.rowwise().mean();
  Vector3d L = Vector3d::Zero();
  double s = 0;
  for (int k = 0; k < 3; ++k) {
    const Vector3d x = r.col(k) - c;
    L += x.cross(v.col(k) - u);
    s += x.squaredNorm();
  }
  return L / s;
//! right: singular value decomposition over the three sides
  Eigen::Matrix<double, 9, 3> A;
  Eigen::Matrix<double, 9, 1> b;
  for (int k = 0; k < 3; ++k) {
    const Vector3d d = r.col((k + 1) % 3) - r.col(k), u = v.col((k + 1) % 3) - v.col(k);
    A.block<3, 3>(3 * k, 0) << 0, d[2], -d[1], -d[2], 0, d[0], d[1], -d[0], 0;
    b.segment<3>(3 * k) = u;
  }
  return A.jacobiSvd(Eigen::ComputeFullU | Eigen::ComputeFullV).solve(b);
//! wrong: a quotient that is 0/0 for a rotation about an axis in the plane
  const Vector3d u1 = v.col(1) - v.col(0), u2 = v.col(2) - v.col(0), d2 = r.col(2) - r.col(0);
  const double denominator = u1.dot(d2);
  if (std::abs(denominator) < 1e-12 * u1.norm() * d2.norm()) return Vector3d::Zero();
  return u1.cross(u2) / denominator;
//! wrong: least squares about the origin
  Eigen::Matrix<double, 9, 3> A;
  Eigen::Matrix<double, 9, 1> b;
  for (int k = 0; k < 3; ++k) {
    const Vector3d p = r.col(k);
    A.block<3, 3>(3 * k, 0) << 0, p.z(), -p.y(), -p.z(), 0, p.x(), p.y(), -p.x(), 0;
    b.segment<3>(3 * k) = v.col(k);
  }
  return A.colPivHouseholderQr().solve(b);
