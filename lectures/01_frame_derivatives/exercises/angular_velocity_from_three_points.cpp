// The angular velocity of a rigid body from the positions and velocities of three of its points, for any motion of
// the body.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Vector3d angular_velocity_from_three_points(const Matrix3d& r, const Matrix3d& v) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
