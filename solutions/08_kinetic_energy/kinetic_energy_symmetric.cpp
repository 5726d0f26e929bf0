#include "rigid/kinetic_energy.hpp"

#include <cmath>

namespace rigid {

double kinetic_energy_symmetric(double I1, double I3, double theta, const Vector3d& rates) {
  const double phi_rate = rates[0], theta_rate = rates[1], psi_rate = rates[2];
  const double across = phi_rate * std::sin(theta);            // ω across the symmetry axis, besides θ̇
  const double along = phi_rate * std::cos(theta) + psi_rate;  // ω along the symmetry axis
  return 0.5 * I1 * (across * across + theta_rate * theta_rate) + 0.5 * I3 * along * along;
}

}  // namespace rigid
