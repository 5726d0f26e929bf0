// Euler's equations on any axes fixed in the body: the angular acceleration from the whole inertia tensor I. The
// products of inertia need not vanish, so it takes more than a division component by component.
#include <rigid/euler_equations.hpp>

namespace rigid {

Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
