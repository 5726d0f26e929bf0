// The time in which the plane of a Foucault pendulum on the northern hemisphere rotates by 360°. The latitude is in
// radians.
#include <rigid/rotating_frames.hpp>

namespace rigid {

double foucault_period(double latitude, double sidereal_day) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
