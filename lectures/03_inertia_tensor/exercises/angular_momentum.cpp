// The angular momentum about the origin of the tensor I. In general it does not point along omega.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

Vector3d angular_momentum(const Matrix3d& I, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
