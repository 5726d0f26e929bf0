// The task stands in include/rigid/euler_equations.hpp; ./checker/run check angular_momentum_rate shows it in short.
#include <rigid/euler_equations.hpp>

namespace rigid {

Vector3d angular_momentum_rate(const Matrix3d& I, const Vector3d& omega, const Vector3d& omega_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
