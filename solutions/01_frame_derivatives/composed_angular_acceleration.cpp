#include "rigid/frame_derivatives.hpp"

namespace rigid {

Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate) {
  // On the inertial axes the rotor has omega + E spin. The platform carries the second part round while its components
  // change: the transport theorem.
  return alpha + E * spin_rate + omega.cross(E * spin);
}

}  // namespace rigid
