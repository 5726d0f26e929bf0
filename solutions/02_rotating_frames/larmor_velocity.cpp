#include "rigid/rotating_frames.hpp"

namespace rigid {

Vector3d larmor_velocity(const Vector3d& qB_over_m, const Vector3d& r_free, const Vector3d& v_free, double t) {
  const Vector3d omega = -qB_over_m / 2;
  const Eigen::AngleAxisd to_laboratory(omega.norm() * t, omega.stableNormalized());
  return to_laboratory * (v_free + omega.cross(r_free));
}

}  // namespace rigid
