#include "rigid/parallel_axis.hpp"

namespace rigid {

Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
  const Vector3d omega = I_cm.llt().solve(r.cross(impulse));
  return impulse / M + omega.cross(p);
}

}  // namespace rigid
