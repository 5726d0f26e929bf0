// The kinetic energy of a body with principal moments I, from its Euler angles (φ, θ, ψ) and their rates. The angles
// are the slides': z–y–z, with the line of nodes along the new y axis.
#include <rigid/kinetic_energy.hpp>

namespace rigid {

double kinetic_energy_euler(const Vector3d& I, const Vector3d& angles, const Vector3d& rates) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
