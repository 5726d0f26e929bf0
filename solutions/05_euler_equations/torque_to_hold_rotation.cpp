#include "rigid/euler_equations.hpp"

namespace rigid {

Vector3d torque_to_hold_rotation(const Matrix3d& I, const Vector3d& omega) {
  const Vector3d L = I * omega;
  return omega.cross(L);  // L is fixed in the body, so its tip moves like a point of the body
}

}  // namespace rigid
