// A satellite is to go from one attitude to another, both given by z–y–z angles, by a single rotation about one axis.
// The smallest possible angle of it, exact to 1e-9 rad also for attitudes that nearly agree.
#include <rigid/euler_angles.hpp>

namespace rigid {

double angle_between_attitudes(const Vector3d& angles1, const Vector3d& angles2) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
