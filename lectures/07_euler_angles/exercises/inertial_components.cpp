// The inertial components of a vector, from its components V_body on the axes of a body with the Euler angles (φ, θ,
// ψ).
#include <rigid/euler_angles.hpp>

namespace rigid {

Vector3d inertial_components(const Vector3d& V_body, const Vector3d& angles) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
