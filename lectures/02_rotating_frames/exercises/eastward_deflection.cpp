// How far to the east of the plumb line a body lands that falls from rest, to first order in earth_rate. The latitude
// is in radians.
#include <rigid/rotating_frames.hpp>

namespace rigid {

double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
