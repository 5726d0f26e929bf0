// The kinetic energy T and the squared angular momentum L², in this order, of a body with principal moments I.
#include <rigid/euler_equations.hpp>

namespace rigid {

Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
