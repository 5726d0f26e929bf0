// The task stands in include/rigid/inertia_tensor.hpp; ./checker/run check rotated_inertia shows it in short.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
