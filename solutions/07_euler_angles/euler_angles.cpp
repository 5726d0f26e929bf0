#include "rigid/euler_angles.hpp"

#include <cmath>

namespace rigid {

Vector3d euler_angles(const Matrix3d& R_body_from_inertial) {
  const Matrix3d& R = R_body_from_inertial;
  // The third row is the body axis ê₃ in inertial components: θ and φ are its polar angles.
  const double theta = std::atan2(std::hypot(R(2, 0), R(2, 1)), R(2, 2));
  const double phi = std::atan2(R(2, 1), R(2, 0));
  // ψ comes from the line of nodes, which R turns from (−sin φ, cos φ, 0) to (sin ψ, cos ψ, 0). So ψ makes up for
  // whatever φ is, and R comes back even where sin θ vanishes and φ means nothing.
  const Vector3d nodes = R * Vector3d(-std::sin(phi), std::cos(phi), 0);
  const double psi = std::atan2(nodes[0], nodes[1]);
  return {phi, theta, psi};
}

}  // namespace rigid
