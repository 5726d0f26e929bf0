#include "rigid/rotating_frames.hpp"

namespace rigid {

Vector3d inertial_acceleration(const Vector3d& a_body, const Vector3d& v_body, const Vector3d& r, const Vector3d& omega,
                               const Vector3d& alpha) {
  const Vector3d coriolis = 2 * omega.cross(v_body);
  const Vector3d euler = alpha.cross(r);
  const Vector3d centripetal = omega.cross(omega.cross(r));  // the brackets matter: (ω×ω)×r is zero
  return a_body + coriolis + euler + centripetal;
}

}  // namespace rigid
