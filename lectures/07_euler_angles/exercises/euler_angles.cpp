// Euler angles (φ, θ, ψ), θ in [0, π], of the attitude with V_body = R V_inertial. Where θ is 0 or π there is more
// than one right answer: any that gives R back will do.
#include <rigid/euler_angles.hpp>

namespace rigid {

Vector3d euler_angles(const Matrix3d& R_body_from_inertial) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
