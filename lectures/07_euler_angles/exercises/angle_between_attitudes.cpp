// The task stands in include/rigid/euler_angles.hpp; ./checker/run check angle_between_attitudes shows it in short.
#include <rigid/euler_angles.hpp>

namespace rigid {

double angle_between_attitudes(const Vector3d& angles1, const Vector3d& angles2) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
