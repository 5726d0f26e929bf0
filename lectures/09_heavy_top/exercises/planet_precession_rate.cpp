// The task stands in include/rigid/heavy_top.hpp; ./checker/run check planet_precession_rate shows it in short.
#include <rigid/heavy_top.hpp>

namespace rigid {

double planet_precession_rate(double I1, double I3, double spin, double orbital_rate, double obliquity) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
