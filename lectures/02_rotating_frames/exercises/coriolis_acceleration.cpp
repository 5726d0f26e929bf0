// The task stands in include/rigid/rotating_frames.hpp; ./checker/run check coriolis_acceleration shows it in short.
#include <rigid/rotating_frames.hpp>

namespace rigid {

Vector3d coriolis_acceleration(const Vector3d& v_enu, double latitude, double earth_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
