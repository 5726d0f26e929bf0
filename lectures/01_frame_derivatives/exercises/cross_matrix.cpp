// The matrix that does what ω× does: cross_matrix(omega) * V is omega × V for every V.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Matrix3d cross_matrix(const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
