// The Poisson brackets of the body components of the angular momentum, as functions of the z–y–z angles and of their
// momenta. sin θ is not zero.
#include <rigid/kinetic_energy.hpp>

namespace rigid {

Matrix3d momentum_brackets(const Vector3d& angles, const Vector3d& momenta) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
