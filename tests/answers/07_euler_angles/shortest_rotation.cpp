#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/euler_angles.hpp>
Matrix3d shortest_rotation(const Vector3d& a, const Vector3d& b) {
//! right: by AngleAxis
  const Vector3d f = a.normalized(), t = b.normalized();
  const Vector3d v = f.cross(t);
  if (v.norm() == 0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(std::atan2(v.norm(), f.dot(t)), v.normalized()).toRotationMatrix();
//! wrong: angle read as its sine
-  return Eigen::AngleAxisd(std::atan2(v.norm(), f.dot(t)), v.normalized()).toRotationMatrix();
+  return Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix();
//! wrong: from b to a
  return Eigen::Quaterniond::FromTwoVectors(b, a).toRotationMatrix();
//! wrong: not normalised
  const Vector3d v = a.cross(b);
  Matrix3d V;
  V << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return Matrix3d::Identity() + V + V * V / (1 + a.dot(b));
//! wrong: one minus cosine in the denominator
  const Vector3d u = a.normalized(), w = b.normalized(), n = u.cross(w);
  const double c = u.dot(w);
  Matrix3d K;
  K << 0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0;
  if (n.norm() == 0) return Matrix3d::Identity();
  return Matrix3d::Identity() + K + K * K / (1 - c);
//! wrong: the angle by its sine
  const Vector3d u = a.normalized(), w = b.normalized();
  const Vector3d axis = u.cross(w);
  const double s = axis.norm();
  if (s < 1e-15) return Matrix3d::Identity();
  return Eigen::AngleAxisd(std::asin(std::min(1.0, s)), axis / s).toRotationMatrix();
