// The canonical momenta (p_φ, p_θ, p_ψ): the derivatives of the kinetic energy with respect to the rates.
#include <rigid/kinetic_energy.hpp>

namespace rigid {

Vector3d canonical_momenta(const Vector3d& I, const Vector3d& angles, const Vector3d& rates) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
