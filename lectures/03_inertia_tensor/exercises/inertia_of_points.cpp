// The inertia tensor of point masses about the origin, from the masses m and the positions in the columns of r. Mind
// the sign off the diagonal, and give back zero when there are no points.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
