#include <cmath>
#include <rigid/rotating_frames.hpp>
Vector3d larmor_velocity(const Vector3d& qB_over_m, const Vector3d& r_free, const Vector3d& v_free, double t) {
//! right: rotated first, then carried
  const Vector3d w = -0.5 * qB_over_m;
  if (w.norm() == 0) return v_free;
  const Matrix3d A = Eigen::AngleAxisd(w.norm() * t, w / w.norm()).toRotationMatrix();
  return A * v_free + w.cross(A * r_free);
//! wrong: velocity only rotated
-  const Matrix3d A = Eigen::AngleAxisd(w.norm() * t, w / w.norm()).toRotationMatrix();
-  return A * v_free + w.cross(A * r_free);
+  return Eigen::AngleAxisd(w.norm() * t, w.normalized()) * v_free;
//! wrong: half in one place only
-  const Matrix3d A = Eigen::AngleAxisd(w.norm() * t, w / w.norm()).toRotationMatrix();
-  return A * v_free + w.cross(A * r_free);
+  return Eigen::AngleAxisd(w.norm() * t, w.normalized()) * Vector3d(v_free - qB_over_m.cross(r_free));
//! wrong: rotated the other way
-  const Matrix3d A = Eigen::AngleAxisd(w.norm() * t, w / w.norm()).toRotationMatrix();
-  return A * v_free + w.cross(A * r_free);
+  return Eigen::AngleAxisd(w.norm() * t, w.normalized()).inverse() * Vector3d(v_free + w.cross(r_free));
//! right: Rodrigues
  const Vector3d w = -0.5 * qB_over_m;
  const double a = w.norm() * t;
  const Vector3d u = v_free + w.cross(r_free);
  if (a == 0) return u;
  const Vector3d n = w.normalized();
  return u * std::cos(a) + n.cross(u) * std::sin(a) + n * n.dot(u) * (1 - std::cos(a));
//! wrong: cyclotron frequency
  const Vector3d w = -qB_over_m;
  if (w.norm() == 0) return v_free;
  return Eigen::AngleAxisd(w.norm() * t, w.normalized()) * Vector3d(v_free + w.cross(r_free));
//! wrong: sign of the charge
  const Vector3d w = 0.5 * qB_over_m;
  if (w.norm() == 0) return v_free;
  return Eigen::AngleAxisd(w.norm() * t, w.normalized()) * Vector3d(v_free + w.cross(r_free));
