// The task stands in include/rigid/rotating_frames.hpp; ./checker/run check shell_drift shows it in short.
#include <rigid/rotating_frames.hpp>

namespace rigid {

double shell_drift(double latitude, double azimuth, double range, double time, double g, double earth_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
