// The task stands in include/rigid/rotating_frames.hpp; ./checker/run check eastward_deflection shows it in short.
#include <rigid/rotating_frames.hpp>

namespace rigid {

double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
