#include "rigid/euler_equations.hpp"

namespace rigid {

Matrix3Xd bearing_forces(const Matrix3d& I_cm, double M, const Vector3d& r_cm, double rate, const Vector2d& bearings) {
  // Across the shaft, all in units of rate²: the force that keeps the centre of mass on its circle, and Σ z_k F_k,
  // which is the torque about the origin, turned by a right angle. It holds the products of inertia about the origin.
  const Vector2d force = -M * r_cm.head<2>();
  const Vector2d moment = I_cm.col(2).head<2>() - M * r_cm[2] * r_cm.head<2>();
  Matrix3Xd forces = Matrix3Xd::Zero(3, 2);
  for (int k = 0; k < 2; ++k) {
    const double own = bearings[k], other = bearings[1 - k];
    forces.col(k).head<2>() = rate * rate * (moment - other * force) / (own - other);
  }
  return forces;
}

}  // namespace rigid
