// The mean rate at which the axis of a planet goes round the normal of its orbit, because its sun pulls at its
// flattened body. Positive in the sense of the orbital motion.
#include <rigid/heavy_top.hpp>

namespace rigid {

double planet_precession_rate(double I1, double I3, double spin, double orbital_rate, double obliquity) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
