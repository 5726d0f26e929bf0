#include "rigid/kinetic_energy.hpp"

#include <cmath>

namespace rigid {

Vector3d canonical_momenta(const Vector3d& I, const Vector3d& angles, const Vector3d& rates) {
  const double theta = angles[1], psi = angles[2];
  // The three axes about which the angles turn the body, in body components: the columns of B in ω = B q̇.
  Matrix3d B;
  B.col(0) << -std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta);  // ê3⁰
  B.col(1) << std::sin(psi), std::cos(psi), 0;                                                     // ê2'
  B.col(2) << 0, 0, 1;                                                                             // ê3

  const Vector3d L_body = I.cwiseProduct(B * rates);
  return B.transpose() * L_body;  // ∂T/∂q̇ = (∂ω/∂q̇)ᵀ L
}

}  // namespace rigid
