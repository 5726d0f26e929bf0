// The task stands in include/rigid/rotating_frames.hpp; ./checker/run check larmor_velocity shows it in short.
#include <rigid/rotating_frames.hpp>

namespace rigid {

Vector3d larmor_velocity(const Vector3d& qB_over_m, const Vector3d& r_free, const Vector3d& v_free, double t) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
