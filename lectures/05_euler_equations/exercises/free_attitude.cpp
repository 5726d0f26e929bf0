// The attitude of a free body at time t. At time 0 its principal axes coincide with the inertial axes and its angular
// velocity is omega0; the columns of the result are its principal axes, in inertial components.
#include <rigid/euler_equations.hpp>

namespace rigid {

Matrix3d free_attitude(const Vector3d& I, const Vector3d& omega0, double t) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
