// A rigid body rotates about a fixed point with the angular velocity omega; I is its inertia tensor about that point
// at this moment, on axes that do not rotate. At what rate do the nine entries of I change?
#include <rigid/inertia_tensor.hpp>

namespace rigid {

Matrix3d inertia_rate(const Matrix3d& I, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
