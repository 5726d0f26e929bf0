// The rates Ω1 and Ω2 of the slides, with their signs, for a small wobble about axis 3. The moments come in any
// order.
#include <rigid/free_tops.hpp>

namespace rigid {

Vector2d linearized_rates(const Vector3d& I, double omega3) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
