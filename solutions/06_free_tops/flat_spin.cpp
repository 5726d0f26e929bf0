#include "rigid/free_tops.hpp"

namespace rigid {

Vector2d flat_spin(const Vector3d& I, const Vector3d& omega) {
  // L is kept; T sinks as far as L allows, to a spin about the axis of the largest moment.
  const Vector3d L = I.cwiseProduct(omega);
  const double largest = I.maxCoeff();
  const Vector3d lost = Vector3d::Ones() - I / largest;  // T − L²/(2 I_max), term by term: nothing cancels
  return {0.5 * L.cwiseProduct(omega).dot(lost), L.stableNorm() / largest};
}

}  // namespace rigid
