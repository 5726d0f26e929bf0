// The task stands in include/rigid/parallel_axis.hpp; ./checker/run check inertia_from_center_of_mass shows it in short.
#include <rigid/parallel_axis.hpp>

namespace rigid {

Matrix3d inertia_from_center_of_mass(const Matrix3d& I_cm, double M, const Vector3d& d) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
