// The Hamiltonian of a free body with principal moments I: its kinetic energy, from the z–y–z angles and their
// canonical momenta. sin θ is not zero.
#include <rigid/kinetic_energy.hpp>

namespace rigid {

double hamiltonian(const Vector3d& I, const Vector3d& angles, const Vector3d& momenta) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
