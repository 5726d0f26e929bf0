#include <cmath>
#include <rigid/frame_derivatives.hpp>
Matrix3Xd screw_of_displacement(const Vector3d& rotation, const Vector3d& d) {
//! right: from sine and cosine
  const double a = rotation.norm(), c = std::cos(a), s = std::sin(a);
  const Vector3d n = rotation.normalized(), along = d.dot(n) * n, u = d - along;
  const Vector3d point = 0.5 * u + s / (2 * (1 - c)) * n.cross(u);
  Matrix3Xd out(3, 2);
  out.col(0) = point;
  out.col(1) = along;
  return out;
//! right: least squares
  const Eigen::AngleAxisd turn(rotation.norm(), rotation.normalized());
  const Vector3d n = turn.axis(), along = d.dot(n) * n;
  const Matrix3d M = Matrix3d::Identity() - turn.toRotationMatrix() + n * n.transpose();
  Matrix3Xd out(3, 2);
  out << M.fullPivLu().solve(Vector3d(d - along)), along;
  return out;
//! wrong: any solution of the singular equations
-  const Matrix3d M = Matrix3d::Identity() - turn.toRotationMatrix() + n * n.transpose();
+  const Matrix3d M = Matrix3d::Identity() - turn.toRotationMatrix();
//! wrong: cotangent of the whole angle
  const double a = rotation.norm();
  const Vector3d n = rotation / a, along = n * n.dot(d);
  Matrix3Xd out(3, 2);
  out << 0.5 * (d - along + n.cross(d) / std::tan(a)), along;
  return out;
//! wrong: order of the cross product
-  out << 0.5 * (d - along + n.cross(d) / std::tan(a)), along;
+  out << 0.5 * (d - along + d.cross(n) / std::tan(a / 2)), along;
//! wrong: the whole shift
-  out << 0.5 * (d - along + n.cross(d) / std::tan(a)), along;
+  out << 0.5 * (d - along + n.cross(d) / std::tan(a / 2)), d;
//! wrong: d with its part along the axis
-  out << 0.5 * (d - along + n.cross(d) / std::tan(a)), along;
+  out << 0.5 * (d + n.cross(d) / std::tan(a / 2)), along;
//! wrong: rotation vector not normalised
  const double a = rotation.norm();
  const Vector3d along = rotation * rotation.dot(d);
  Matrix3Xd out(3, 2);
  out << 0.5 * (d - along + rotation.cross(d) / std::tan(a / 2)), along;
  return out;
