#include "rigid/rotating_frames.hpp"

namespace rigid {

Vector3d fictitious_force(double m, const Vector3d& r, const Vector3d& v_body, const Vector3d& omega,
                          const Vector3d& alpha) {
  // What the inertial acceleration has beyond that of the turning frame is what the turning observer calls a force.
  return -m * inertial_acceleration(Vector3d::Zero(), v_body, r, omega, alpha);
}

}  // namespace rigid
