// The torque that a body with inertia tensor I needs to go on rotating with the constant angular velocity omega.
#include <rigid/euler_equations.hpp>

namespace rigid {

Vector3d torque_to_hold_rotation(const Matrix3d& I, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
