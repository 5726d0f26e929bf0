#include "rigid/euler_equations.hpp"

namespace rigid {

Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  return {0.5 * L.dot(omega), L.squaredNorm()};
}

}  // namespace rigid
