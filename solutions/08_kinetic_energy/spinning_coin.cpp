#include "rigid/kinetic_energy.hpp"

#include <cmath>

namespace rigid {

double spinning_coin(double radius, double g, double inclination) {
  // Per unit mass. Centre and point of contact are at rest, so ω = Ω sin α lies along a diameter, and L = ¼ a² ω too.
  // Its level part, L cos α, goes round at the rate Ω and needs the torque of the table's force about the centre.
  const double L_per_rate = 0.25 * radius * radius * std::sin(inclination);  // L = L_per_rate Ω
  const double torque = g * radius * std::cos(inclination);
  return std::sqrt(torque / (L_per_rate * std::cos(inclination)));
}

}  // namespace rigid
