// How far to the right of the line of fire a shell lands, to first order in earth_rate.
#include <rigid/rotating_frames.hpp>

namespace rigid {

double shell_drift(double latitude, double azimuth, double range, double time, double g, double earth_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
