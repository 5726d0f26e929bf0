// The task stands in include/rigid/euler_angles.hpp; ./checker/run check vertical_in_body shows it in short.
#include <rigid/euler_angles.hpp>

namespace rigid {

Vector3d vertical_in_body(double theta, double psi) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
