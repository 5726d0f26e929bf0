// The angular velocity, in inertial components, of a basis E whose columns change at the rates in the columns of
// E_rate.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Vector3d angular_velocity_of_basis(const Matrix3d& E, const Matrix3d& E_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
