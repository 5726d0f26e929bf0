#include <cmath>
#include <rigid/measured.hpp>
Matrix3d attitude_from_rates(const VectorXd& t, const Matrix3Xd& omega) {
//! right: Rodrigues by hand
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
//! wrong: rotations at rest
  Matrix3d A = Matrix3d::Identity();
  for (int k = 1; k < t.size(); ++k) {
    const Vector3d v = (t[k] - t[k - 1]) * (omega.col(k) + omega.col(k - 1)) / 2;
    A = Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix() * A;
  }
  return A;
//! wrong: no rotation divided by zero
-    A = Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix() * A;
+    A = A * Eigen::AngleAxisd(v.norm(), v / v.norm()).toRotationMatrix();
//! wrong: Euler angles of the steps
-    A = Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix() * A;
+    A = A * Eigen::AngleAxisd(v[0], Vector3d::UnitX()) * Eigen::AngleAxisd(v[1], Vector3d::UnitY()) *
+        Eigen::AngleAxisd(v[2], Vector3d::UnitZ());
//! wrong: half angles forgotten in the quaternion
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (int k = 1; k < t.size(); ++k) {
    const Vector3d v = (t[k] - t[k - 1]) * (omega.col(k) + omega.col(k - 1)) / 2;
    const double angle = v.norm();
    const Vector3d n = v.normalized() * std::sin(angle);
    q = q * Eigen::Quaterniond(std::cos(angle), n[0], n[1], n[2]);
  }
  return q.normalized().toRotationMatrix();
//! wrong: all steps of the mean length
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  const double dt = (t(t.size() - 1) - t(0)) / (t.size() - 1);
  for (int k = 1; k < t.size(); k++) {
    const Vector3d w = 0.5 * (omega.col(k) + omega.col(k - 1));
    const double angle = w.norm() * dt;
    if (angle > 0) q = q * Eigen::Quaterniond(Eigen::AngleAxisd(angle, w.normalized()));
  }
  return q.toRotationMatrix();
