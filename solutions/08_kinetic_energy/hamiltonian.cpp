#include "rigid/kinetic_energy.hpp"

#include <cmath>

namespace rigid {

double hamiltonian(const Vector3d& I, const Vector3d& angles, const Vector3d& momenta) {
  const double theta = angles[1], psi = angles[2];
  const double p_phi = momenta[0], p_theta = momenta[1], p_psi = momenta[2];
  // L along ê₁′, in the plane of the vertical and ê₃: L·ê₃⁰ = −sin θ L·ê₁′ + cos θ L·ê₃
  const double across = (p_psi * std::cos(theta) - p_phi) / std::sin(theta);
  const Vector3d L_body(across * std::cos(psi) + p_theta * std::sin(psi),
                        -across * std::sin(psi) + p_theta * std::cos(psi), p_psi);
  return 0.5 * L_body.cwiseAbs2().cwiseQuotient(I).sum();
}

}  // namespace rigid
