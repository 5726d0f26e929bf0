#include "rigid/euler_equations.hpp"

namespace rigid {

Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  const Vector3d L = I * omega;
  return I.ldlt().solve(torque - omega.cross(L));  // an inertia tensor is symmetric and positive definite
}

}  // namespace rigid
