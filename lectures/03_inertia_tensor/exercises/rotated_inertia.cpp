// The inertia tensor on inertial axes of a body whose tensor on its own axes is I_body. The rotation matrix A takes
// body components to inertial ones: V_inertial = A V_body.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
