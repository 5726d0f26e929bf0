// The task stands in include/rigid/euler_equations.hpp; ./checker/run check euler_equations_general shows it in short.
#include <rigid/euler_equations.hpp>

namespace rigid {

Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
