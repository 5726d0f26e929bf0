// The inertial vertical ê₃⁰ (the axis of the first rotation) in body components.
#include <rigid/euler_angles.hpp>

namespace rigid {

Vector3d vertical_in_body(double theta, double psi) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
