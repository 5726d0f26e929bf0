#include "rigid/parallel_axis.hpp"

namespace rigid {

Matrix3d inertia_from_center_of_mass(const Matrix3d& I_cm, double M, const Vector3d& d) {
  // Seen from the point, the body adds to its own tensor that of a single mass M at the centre of mass.
  return I_cm + M * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
}

}  // namespace rigid
