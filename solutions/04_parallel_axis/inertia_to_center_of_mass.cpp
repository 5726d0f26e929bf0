#include "rigid/parallel_axis.hpp"

namespace rigid {

Matrix3d inertia_to_center_of_mass(const Matrix3d& I_origin, double M, const Vector3d& r_cm) {
  return I_origin - M * (r_cm.squaredNorm() * Matrix3d::Identity() - r_cm * r_cm.transpose());
}

}  // namespace rigid
