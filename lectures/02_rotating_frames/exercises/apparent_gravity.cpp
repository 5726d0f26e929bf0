// The task stands in include/rigid/rotating_frames.hpp; ./checker/run check apparent_gravity shows it in short.
#include <rigid/rotating_frames.hpp>

namespace rigid {

Vector3d apparent_gravity(double latitude, double radius, double g0, double earth_rate, const Vector2d& v) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
