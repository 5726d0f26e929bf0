// The task stands in include/rigid/euler_equations.hpp; ./checker/run check free_rotation shows it in short.
#include <rigid/euler_equations.hpp>

namespace rigid {

Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
