// The rate of change of the angular momentum as seen from the inertial frame, on the axes of the body, when the
// components of omega change at the rates omega_rate.
#include <rigid/euler_equations.hpp>

namespace rigid {

Vector3d angular_momentum_rate(const Matrix3d& I, const Vector3d& omega, const Vector3d& omega_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
