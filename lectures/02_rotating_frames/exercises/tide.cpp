// The task stands in include/rigid/rotating_frames.hpp; ./checker/run check tide shows it in short.
#include <rigid/rotating_frames.hpp>

namespace rigid {

double tide(double mass_ratio, double radius, double distance, double angle) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
