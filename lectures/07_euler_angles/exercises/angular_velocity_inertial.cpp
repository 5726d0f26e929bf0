// The task stands in include/rigid/euler_angles.hpp; ./checker/run check angular_velocity_inertial shows it in short.
#include <rigid/euler_angles.hpp>

namespace rigid {

Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
