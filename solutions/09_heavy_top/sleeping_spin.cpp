#include "rigid/heavy_top.hpp"

#include <cmath>

namespace rigid {

double sleeping_spin(double I1, double I3, double mgl) { return 2 * std::sqrt(I1 * mgl) / I3; }

}  // namespace rigid
