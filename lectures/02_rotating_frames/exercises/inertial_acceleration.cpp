// The acceleration in the inertial frame of a point that has position r, velocity v_body and acceleration a_body in a
// frame rotating with omega, whose own rate is alpha. All vectors are on the same axes.
#include <rigid/rotating_frames.hpp>

namespace rigid {

Vector3d inertial_acceleration(const Vector3d& a_body, const Vector3d& v_body, const Vector3d& r,
                               const Vector3d& omega, const Vector3d& alpha) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
