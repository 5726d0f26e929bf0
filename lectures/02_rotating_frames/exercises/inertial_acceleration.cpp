// The task stands in include/rigid/rotating_frames.hpp; ./checker/run check inertial_acceleration shows it in short.
#include <rigid/rotating_frames.hpp>

namespace rigid {

Vector3d inertial_acceleration(const Vector3d& a_body, const Vector3d& v_body, const Vector3d& r,
                               const Vector3d& omega, const Vector3d& alpha) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
