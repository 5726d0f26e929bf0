// The rotation matrix that carries the direction of a into the direction of b by the smallest possible angle. The
// vector turns, the axes stay.
#include <rigid/euler_angles.hpp>

namespace rigid {

Matrix3d shortest_rotation(const Vector3d& a, const Vector3d& b) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
