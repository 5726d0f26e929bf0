#include "rigid/euler_angles.hpp"

#include <cmath>

namespace rigid {

Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body) {
  const double theta = angles[1], psi = angles[2];
  const double along_nodes = omega_body[0] * std::sin(psi) + omega_body[1] * std::cos(psi);
  // Across the line of nodes, in the plane of ê₁ and ê₂, only φ̇ contributes, with its share sin θ.
  const double across_nodes = -omega_body[0] * std::cos(psi) + omega_body[1] * std::sin(psi);
  const double phi_rate = across_nodes / std::sin(theta);
  return {phi_rate, along_nodes, omega_body[2] - phi_rate * std::cos(theta)};
}

}  // namespace rigid
