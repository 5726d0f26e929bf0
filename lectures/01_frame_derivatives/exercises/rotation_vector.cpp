// The one rotation about a fixed axis that takes the inertial axes to the columns of E: the vector along its axis
// with the angle as length, to nine digits for any angle.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Vector3d rotation_vector(const Matrix3d& E) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
