// The rotation matrix R of the slides, V_body = R V_inertial, from the Euler angles (φ, θ, ψ): φ about the vertical,
// θ about the new y axis (the line of nodes), ψ about the body's own z axis.
#include <rigid/euler_angles.hpp>

namespace rigid {

Matrix3d rotation_matrix(const Vector3d& angles) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
