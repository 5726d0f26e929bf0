// The moment of inertia about an axis through the origin. The vector axis gives its direction and may have any
// length.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

double moment_about_axis(const Matrix3d& I, const Vector3d& axis) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
