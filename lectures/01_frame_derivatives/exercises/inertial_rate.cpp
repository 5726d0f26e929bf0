// The task stands in include/rigid/frame_derivatives.hpp; ./checker/run check inertial_rate shows it in short.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
