#include "rigid/kinetic_energy.hpp"

#include <cmath>

namespace rigid {

double kinetic_energy_euler(const Vector3d& I, const Vector3d& angles, const Vector3d& rates) {
  const double theta = angles[1], psi = angles[2];  // φ does not enter: no direction in the horizontal plane is special
  const double phi_rate = rates[0], theta_rate = rates[1], psi_rate = rates[2];
  const Vector3d omega_body(-phi_rate * std::sin(theta) * std::cos(psi) + theta_rate * std::sin(psi),
                            phi_rate * std::sin(theta) * std::sin(psi) + theta_rate * std::cos(psi),
                            phi_rate * std::cos(theta) + psi_rate);
  return 0.5 * I.dot(omega_body.cwiseAbs2());
}

}  // namespace rigid
