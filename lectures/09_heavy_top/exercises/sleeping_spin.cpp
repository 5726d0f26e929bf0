// A top spins upright on its tip. Friction slows it down. The spin at which it begins to wobble.
#include <rigid/heavy_top.hpp>

namespace rigid {

double sleeping_spin(double I1, double I3, double mgl) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
