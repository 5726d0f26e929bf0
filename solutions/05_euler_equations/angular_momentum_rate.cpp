#include "rigid/euler_equations.hpp"

namespace rigid {

Vector3d angular_momentum_rate(const Matrix3d& I, const Vector3d& omega, const Vector3d& omega_rate) {
  const Vector3d L = I * omega;
  return I * omega_rate + omega.cross(L);  // what the body sees, and what the turning of the body adds
}

}  // namespace rigid
