// The kinetic energy of a body with inertia tensor I that rotates with angular velocity omega about the tensor's
// origin.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

double kinetic_energy(const Matrix3d& I, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
