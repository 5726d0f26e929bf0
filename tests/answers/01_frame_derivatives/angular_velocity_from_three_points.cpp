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
