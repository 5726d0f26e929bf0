// The task stands in include/rigid/frame_derivatives.hpp; ./checker/run check screw_of_displacement shows it in short.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Matrix3Xd screw_of_displacement(const Vector3d& rotation, const Vector3d& d) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
