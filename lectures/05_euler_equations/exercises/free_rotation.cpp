// The angular velocity of a free body with principal moments I, one column per entry of times; it is omega0 at t = 0.
// The times come in any order and may be negative; the steps of the integration are yours to choose.
#include <rigid/euler_equations.hpp>

namespace rigid {

Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
