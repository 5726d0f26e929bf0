//! right: Rodrigues by hand
#include <cmath>
#include <rigid/measured.hpp>
namespace rigid {
Matrix3d attitude_from_rates(const VectorXd& t, const Matrix3Xd& omega) {
  Matrix3d A = Matrix3d::Identity();
  for (int k = 1; k < t.size(); ++k) {
    const Vector3d v = (t[k] - t[k - 1]) * (omega.col(k) + omega.col(k - 1)) / 2;
    const double angle = v.norm();
    if (angle == 0) continue;
    const Vector3d n = v / angle;
    const Matrix3d N{{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}};
    A = A * (Matrix3d::Identity() + std::sin(angle) * N + (1 - std::cos(angle)) * N * N);
  }
  return A;
}
}  // namespace rigid

//! wrong: no rotation divided by zero
#include <cmath>
#include <rigid/measured.hpp>
namespace rigid {
Matrix3d attitude_from_rates(const VectorXd& t, const Matrix3Xd& omega) {
  Matrix3d A = Matrix3d::Identity();
  for (int k = 1; k < t.size(); ++k) {
    const Vector3d v = (t[k] - t[k - 1]) * (omega.col(k) + omega.col(k - 1)) / 2;
    A = A * Eigen::AngleAxisd(v.norm(), v / v.norm()).toRotationMatrix();
  }
  return A;
}
}  // namespace rigid

//! wrong: rotations at rest
#include <cmath>
#include <rigid/measured.hpp>
namespace rigid {
Matrix3d attitude_from_rates(const VectorXd& t, const Matrix3Xd& omega) {
  Matrix3d A = Matrix3d::Identity();
  for (int k = 1; k < t.size(); ++k) {
    const Vector3d v = (t[k] - t[k - 1]) * (omega.col(k) + omega.col(k - 1)) / 2;
    A = Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix() * A;
  }
  return A;
}
}  // namespace rigid

//! wrong: Euler angles of the steps
#include <cmath>
#include <rigid/measured.hpp>
namespace rigid {
Matrix3d attitude_from_rates(const VectorXd& t, const Matrix3Xd& omega) {
  Matrix3d A = Matrix3d::Identity();
  for (int k = 1; k < t.size(); ++k) {
    const Vector3d v = (t[k] - t[k - 1]) * (omega.col(k) + omega.col(k - 1)) / 2;
    A = A * Eigen::AngleAxisd(v[0], Vector3d::UnitX()) * Eigen::AngleAxisd(v[1], Vector3d::UnitY()) *
        Eigen::AngleAxisd(v[2], Vector3d::UnitZ());
  }
  return A;
}
}  // namespace rigid

//! wrong: half angles forgotten in the quaternion
#include <cmath>
#include <rigid/measured.hpp>
namespace rigid {
Matrix3d attitude_from_rates(const VectorXd& t, const Matrix3Xd& omega) {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (int k = 1; k < t.size(); ++k) {
    const Vector3d v = (t[k] - t[k - 1]) * (omega.col(k) + omega.col(k - 1)) / 2;
    const double angle = v.norm();
    const Vector3d n = v.normalized() * std::sin(angle);
    q = q * Eigen::Quaterniond(std::cos(angle), n[0], n[1], n[2]);
  }
  return q.normalized().toRotationMatrix();
}
}  // namespace rigid
