// The rate of change of V in the inertial frame, from the rate that is seen in a frame rotating with omega. All
// vectors are on the same axes.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
