#include <algorithm>
#include <cmath>
#include <rigid/euler_angles.hpp>
double angle_between_attitudes(const Vector3d& angles1, const Vector3d& angles2) {
//! wrong: arccosine of the trace
  using A = Eigen::AngleAxisd;
  auto m = [](const Vector3d& a) -> Matrix3d { return (A(a[0], Vector3d::UnitZ()) * A(a[1], Vector3d::UnitY()) * A(a[2], Vector3d::UnitZ())).toRotationMatrix(); };
  const double c = ((m(angles1).transpose() * m(angles2)).trace() - 1) / 2;
  return std::acos(std::clamp(c, -1.0, 1.0));
//! right: sine and cosine from both matrices
  using A = Eigen::AngleAxisd;
  auto m = [](const Vector3d& a) -> Matrix3d { return (A(a[0], Vector3d::UnitZ()) * A(a[1], Vector3d::UnitY()) * A(a[2], Vector3d::UnitZ())).toRotationMatrix(); };
  const Matrix3d a = m(angles1), b = m(angles2);
  const Matrix3d D = a.transpose() * b;
  const double sine = Vector3d(D(2, 1) - D(1, 2), D(0, 2) - D(2, 0), D(1, 0) - D(0, 1)).norm() / 2;
  return std::atan2(sine, (D.trace() - 1) / 2);
//! wrong: arc sine of the antisymmetric part
  const auto q = [](const Vector3d& a) {
    return Eigen::AngleAxisd(a[0], Vector3d::UnitZ()) * Eigen::AngleAxisd(a[1], Vector3d::UnitY()) *
           Eigen::AngleAxisd(a[2], Vector3d::UnitZ());
  };
  const Matrix3d D = (q(angles1).conjugate() * q(angles2)).toRotationMatrix();
  const Vector3d v(D(2, 1) - D(1, 2), D(0, 2) - D(2, 0), D(1, 0) - D(0, 1));
  return std::asin(std::min(1.0, v.norm() / 2));
//! wrong: differences of the angles as a rotation vector
  Vector3d d = angles2 - angles1;
  for (int i = 0; i < 3; ++i) d[i] = std::remainder(d[i], 2 * M_PI);
  return std::min(d.norm(), M_PI);
//! right: distance and sum of unit quaternions
  const auto q = [](const Vector3d& e) {
    const double c = std::cos(e[1] / 2), s = std::sin(e[1] / 2), sum = (e[0] + e[2]) / 2, difference = (e[2] - e[0]) / 2;
    return Eigen::Vector4d(c * std::cos(sum), s * std::sin(difference), s * std::cos(difference), c * std::sin(sum));
  };
  const double minus = (q(angles1) - q(angles2)).norm(), plus = (q(angles1) + q(angles2)).norm();
  return 4 * std::atan2(std::min(minus, plus), std::max(minus, plus));
