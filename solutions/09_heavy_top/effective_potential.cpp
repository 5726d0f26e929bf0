#include "rigid/heavy_top.hpp"

#include <cmath>

namespace rigid {

double effective_potential(double I1, double I3, double mgl, double p_phi, double p_psi, double theta) {
  const double across = (p_phi - p_psi * std::cos(theta)) / std::sin(theta);  // of L, in the vertical plane of the axis
  return across * across / (2 * I1) + p_psi * p_psi / (2 * I3) + mgl * std::cos(theta);
}

}  // namespace rigid
