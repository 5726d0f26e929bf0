// The inertia tensor about the origin of a uniform body that is given by its surface: triangles, three columns of
// corners each, anticlockwise as seen from outside. The origin may lie anywhere, and the body may have hollows.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

Matrix3d inertia_of_mesh(const Matrix3Xd& corners, double density) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
