#include "rigid/heavy_top.hpp"

#include <cmath>

namespace rigid {

double planet_precession_rate(double I1, double I3, double spin, double orbital_rate, double obliquity) {
  return -1.5 * (orbital_rate / spin) * orbital_rate * ((I3 - I1) / I3) * std::cos(obliquity);
}

}  // namespace rigid
