// Can the matrix I be the inertia tensor of a body made of positive masses? Return 1 or 0. What is violated by less
// than 1e-9 of the largest entry counts as rounding.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

int is_inertia_tensor(const Matrix3d& I) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
