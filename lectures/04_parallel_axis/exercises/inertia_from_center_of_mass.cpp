// The inertia tensor about a point at d from the centre of mass, from the tensor I_cm about the centre of mass.
#include <rigid/parallel_axis.hpp>

namespace rigid {

Matrix3d inertia_from_center_of_mass(const Matrix3d& I_cm, double M, const Vector3d& d) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
