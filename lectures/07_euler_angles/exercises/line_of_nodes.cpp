// The task stands in include/rigid/euler_angles.hpp; ./checker/run check line_of_nodes shows it in short.
#include <rigid/euler_angles.hpp>

namespace rigid {

Vector3d line_of_nodes(double psi) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
