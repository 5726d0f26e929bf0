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
  const Vector3d w = I_cm.inverse() * p.cross(impulse);
  return impulse / M + w.cross(p);
//! wrong: impulse cross r
  const Vector3d w = I_cm.inverse() * impulse.cross(r);
  return impulse / M + w.cross(p);
//! wrong: tensor multiplied instead of inverted
  const Vector3d w = I_cm * r.cross(impulse);
  return impulse / M + w.cross(p);
//! wrong: momentum instead of velocity
  const Vector3d w = I_cm.inverse() * r.cross(impulse);
  return impulse + M * w.cross(p);
//! wrong: p scaled by M
  const Vector3d w = I_cm.inverse() * r.cross(impulse);
  return (impulse + w.cross(p)) / M;
//! wrong: auto keeps an expression
  auto w = I_cm.inverse() * r.cross(impulse).eval().normalized();
  return impulse / M + w.cross(p);
//! wrong: impulse before its lever, and no mass
  return impulse + (I_cm.inverse() * impulse.cross(r)).cross(p);
//! wrong: the lever of the blow from the point
  const Vector3d kick = (r - p).cross(impulse);
  const Vector3d omega = I_cm.ldlt().solve(kick);
  return impulse / M + omega.cross(p);
