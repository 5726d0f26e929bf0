#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/parallel_axis.hpp>
Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
//! right: two laws
  const Vector3d w = I_cm.inverse() * r.cross(impulse);
  return impulse / M + w.cross(p);
//! wrong: lever from p
-  const Vector3d w = I_cm.inverse() * r.cross(impulse);
+  const Vector3d w = I_cm.inverse() * p.cross(impulse);
//! wrong: impulse cross r
-  const Vector3d w = I_cm.inverse() * r.cross(impulse);
+  const Vector3d w = I_cm.inverse() * impulse.cross(r);
//! wrong: tensor multiplied instead of inverted
-  const Vector3d w = I_cm.inverse() * r.cross(impulse);
+  const Vector3d w = I_cm * r.cross(impulse);
//! wrong: momentum instead of velocity
-  return impulse / M + w.cross(p);
+  return impulse + M * w.cross(p);
//! wrong: p scaled by M
-  return impulse / M + w.cross(p);
+  return (impulse + w.cross(p)) / M;
//! wrong: auto keeps an expression
-  const Vector3d w = I_cm.inverse() * r.cross(impulse);
+  auto w = I_cm.inverse() * r.cross(impulse).eval().normalized();
//! wrong: impulse before its lever, and no mass
  return impulse + (I_cm.inverse() * impulse.cross(r)).cross(p);
//! wrong: the lever of the blow from the point
Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
  const Vector3d kick = (r - p).cross(impulse);
  const Vector3d omega = I_cm.ldlt().solve(kick);
  return impulse / M + omega.cross(p);
}
