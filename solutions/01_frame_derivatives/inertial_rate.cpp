#include "rigid/frame_derivatives.hpp"

namespace rigid {

Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V) {
  return rate_body + omega.cross(V);
}

}  // namespace rigid
