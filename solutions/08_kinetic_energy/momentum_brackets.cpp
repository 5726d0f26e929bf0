#include "rigid/kinetic_energy.hpp"

#include <cmath>

namespace rigid {

Matrix3d momentum_brackets(const Vector3d& angles, const Vector3d& momenta) {
  const double theta = angles[1], psi = angles[2];
  const double across = (momenta[2] * std::cos(theta) - momenta[0]) / std::sin(theta);
  const Vector3d L(across * std::cos(psi) + momenta[1] * std::sin(psi),
                   -across * std::sin(psi) + momenta[1] * std::cos(psi), momenta[2]);
  // {L̃ᵢ, L̃ⱼ} = −εᵢⱼₖ L̃ₖ
  return Matrix3d{{0, -L[2], L[1]}, {L[2], 0, -L[0]}, {-L[1], L[0], 0}};
}

}  // namespace rigid
