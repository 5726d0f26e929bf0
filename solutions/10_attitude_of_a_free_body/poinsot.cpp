#include "rigid/attitude_of_a_free_body.hpp"

namespace rigid {

Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  // The normal of the ellipsoid at ω is the gradient of T, which is L: one distance is the part of ω along L, the other
  // the part across it. The cross product keeps its digits where ω is nearly along L.
  const Vector3d L = I.cwiseProduct(omega);
  return Vector2d(omega.dot(L), omega.cross(L).norm()) / L.norm();
}

}  // namespace rigid
