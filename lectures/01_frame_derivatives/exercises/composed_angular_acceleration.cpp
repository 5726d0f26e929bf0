// The task stands in include/rigid/frame_derivatives.hpp; ./checker/run check composed_angular_acceleration shows it in short.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
