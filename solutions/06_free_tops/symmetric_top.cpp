#include "rigid/free_tops.hpp"

namespace rigid {

Vector3d symmetric_top(double I1, double I3, const Vector3d& omega0, double t) {
  // Turning the initial vector needs neither amplitude nor phase, so nothing is undefined when there is no wobble.
  const double angle = omega0[2] * (I3 - I1) / I1 * t;
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega0;
}

}  // namespace rigid
