#include <cmath>
#include <rigid/frame_derivatives.hpp>
Matrix3d rotated_basis(const Matrix3d& E, const Vector3d& omega, double dt) {
//! right: Rodrigues, column by column
  const double speed = omega.norm();
  if (speed == 0) return E;
  const Vector3d n = omega / speed;
  const double c = std::cos(speed * dt), s = std::sin(speed * dt);
  Matrix3d result;
  for (int i = 0; i < 3; ++i) {
    const Vector3d e = E.col(i);
    result.col(i) = c * e + s * n.cross(e) + (1 - c) * n.dot(e) * n;
  }
  return result;
//! wrong: cos instead of one minus cos
-  const double c = std::cos(speed * dt), s = std::sin(speed * dt);
@@
-    result.col(i) = c * e + s * n.cross(e) + (1 - c) * n.dot(e) * n;
+    result.col(i) = e + std::sin(speed * dt) * n.cross(e) + std::cos(speed * dt) * n.cross(n.cross(e));
//! right: a quaternion
  const double half = omega.norm() * dt / 2;
  const Vector3d n = omega.normalized();
  const Eigen::Quaterniond q(std::cos(half), n.x() * std::sin(half), n.y() * std::sin(half), n.z() * std::sin(half));
  return q.toRotationMatrix() * E;
//! right: the same rotation about the axes of the body
  if (omega.norm() == 0) return E;
  const Vector3d omega_body = E.transpose() * omega;
  return E * Eigen::AngleAxisd(omega_body.norm() * dt, omega_body.normalized()).toRotationMatrix();
//! wrong: about the axes of the body
  if (omega.isZero(0)) return E;
  const Eigen::AngleAxisd rotation(omega.norm() * dt, omega / omega.norm());
  return E * rotation.toRotationMatrix();
//! wrong: only to first order
  Matrix3d result;
  for (int i = 0; i < 3; ++i) result.col(i) = E.col(i) + omega.cross(E.col(i)) * dt;
  return result;
//! wrong: the other way round
  const double angle = -omega.norm() * dt;
  return Eigen::AngleAxisd(angle, omega.normalized()) * E;
//! wrong: divides by zero at rest
  const Vector3d n = omega / omega.norm();
  return Eigen::AngleAxisd(omega.norm() * dt, n).toRotationMatrix() * E;
//! wrong: the axis is not normalised
  return Eigen::AngleAxisd(omega.norm() * dt, omega).toRotationMatrix() * E;
//! wrong: every slow rotation is taken for none
  const double speed = omega.norm();
  if (speed < 1e-3) return E;
  return Eigen::AngleAxisd(speed * dt, omega / speed).toRotationMatrix() * E;
//! wrong: negative times run forwards
  const double angle = omega.norm() * std::abs(dt);
  if (angle == 0) return E;
  return Eigen::AngleAxisd(angle, omega.normalized()).toRotationMatrix() * E;
//! wrong: half steps before and behind, without the tangent
  Matrix3d W;
  W << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
  const Matrix3d one = Matrix3d::Identity();
  return (one - dt / 2 * W).inverse() * (one + dt / 2 * W) * E;
//! right: matrix exponential by scaling and squaring
  Eigen::Matrix<long double, 3, 3> W, X = Eigen::Matrix<long double, 3, 3>::Identity(), T = X;
  W << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
  W *= static_cast<long double>(dt);
  int s = 0;
  while (W.cwiseAbs().maxCoeff() > 0.125L) {
    W /= 2;
    ++s;
  }
  for (int k = 1; k < 20; ++k) {
    T = T * W / static_cast<long double>(k);
    X += T;
  }
  for (int k = 0; k < s; ++k) X = X * X;
  return X.cast<double>() * E;
