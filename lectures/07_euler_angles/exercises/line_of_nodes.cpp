// The line of nodes ê₂′ (the axis of the second rotation) in body components.
#include <rigid/euler_angles.hpp>

namespace rigid {

Vector3d line_of_nodes(double psi) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
