#include "rigid/euler_equations.hpp"

namespace rigid {

Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Vector3d L = I.cwiseProduct(omega);
  return (torque - omega.cross(L)).cwiseQuotient(I);
}

}  // namespace rigid
