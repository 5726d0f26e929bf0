// Euler's equations: the rates of change of the components of omega on the principal axes, from the principal moments
// I and the torque on the same axes.
#include <rigid/euler_equations.hpp>

namespace rigid {

Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
