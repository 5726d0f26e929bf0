//! wrong: E transposed for the spin rate only
#include "rigid/frame_derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate) {
  return alpha + E.transpose() * spin_rate + omega.cross(E * spin);
}

}  // namespace rigid
//! wrong: E transposed everywhere
#include "rigid/frame_derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate) {
  return alpha + E.transpose() * spin_rate + omega.cross(E.transpose() * spin);
}

}  // namespace rigid
//! wrong: alpha forgotten
#include "rigid/frame_derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate) {
  return E * spin_rate + omega.cross(E * spin);
}

}  // namespace rigid
//! wrong: omega taken as body components
#include "rigid/frame_derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate) {
  return alpha + E * (spin_rate + omega.cross(spin));
}

}  // namespace rigid
//! wrong: spin rate in place of spin
#include "rigid/frame_derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate) {
  return alpha + E * spin_rate + omega.cross(E * spin_rate);
}

}  // namespace rigid
//! right: written with the total angular velocity
#include "rigid/frame_derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate) {
  const Vector3d total = omega + E * spin;
  Vector3d sum = omega.cross(total);
  sum += alpha;
  sum += E * spin_rate;
  return sum;
}

}  // namespace rigid
