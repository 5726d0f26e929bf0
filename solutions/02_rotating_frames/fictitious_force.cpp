#include "rigid/rotating_frames.hpp"

namespace rigid {

Vector3d fictitious_force(double m, const Vector3d& r, const Vector3d& v_body, const Vector3d& omega,
                          const Vector3d& alpha) {
  // What the inertial acceleration has beyond that of the turning frame is what the turning observer calls a force.
  const Vector3d coriolis = 2 * omega.cross(v_body);
  const Vector3d euler = alpha.cross(r);
  const Vector3d centripetal = omega.cross(omega.cross(r));
  return -m * (coriolis + euler + centripetal);
}

}  // namespace rigid
