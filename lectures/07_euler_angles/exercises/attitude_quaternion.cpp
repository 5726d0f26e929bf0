// The unit quaternion (w, x, y, z) of the attitude with the z–y–z angles (φ, θ, ψ): the rotation that carries the
// inertial axes onto the body axes.
#include <rigid/euler_angles.hpp>

namespace rigid {

VectorXd attitude_quaternion(const Vector3d& angles) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
