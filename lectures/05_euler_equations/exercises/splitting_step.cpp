// One step of free rotation, put together from exact motions: the energy is a sum of three terms, and L follows the
// first term alone for h/2, the second for h/2, the third for h, the second for h/2, the first for h/2. Return the
// angular velocity at the end.
#include <rigid/euler_equations.hpp>

namespace rigid {

Vector3d splitting_step(const Vector3d& I, const Vector3d& omega, double h) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
