// The task stands in include/rigid/frame_derivatives.hpp; ./checker/run check angular_velocity_of_basis shows it in short.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Vector3d angular_velocity_of_basis(const Matrix3d& E, const Matrix3d& E_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
