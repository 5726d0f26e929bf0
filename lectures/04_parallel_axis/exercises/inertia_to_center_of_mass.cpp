// The inertia tensor about the centre of mass, which sits at r_cm, from the tensor about the origin.
#include <rigid/parallel_axis.hpp>

namespace rigid {

Matrix3d inertia_to_center_of_mass(const Matrix3d& I_origin, double M, const Vector3d& r_cm) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
