// The task stands in include/rigid/euler_angles.hpp; ./checker/run check euler_angle_rates shows it in short.
#include <rigid/euler_angles.hpp>

namespace rigid {

Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
