#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/frame_derivatives.hpp>
Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate) {
//! right: written with the total angular velocity
  const Vector3d total = omega + E * spin;
  Vector3d sum = omega.cross(total);
  sum += alpha;
  sum += E * spin_rate;
  return sum;
//! wrong: E transposed for the spin rate only
  return alpha + E.transpose() * spin_rate + omega.cross(E * spin);
//! wrong: E transposed everywhere
  return alpha + E.transpose() * spin_rate + omega.cross(E.transpose() * spin);
//! wrong: alpha forgotten
  return E * spin_rate + omega.cross(E * spin);
//! wrong: omega taken as body components
  return alpha + E * (spin_rate + omega.cross(spin));
//! wrong: spin rate in place of spin
  return alpha + E * spin_rate + omega.cross(E * spin_rate);
