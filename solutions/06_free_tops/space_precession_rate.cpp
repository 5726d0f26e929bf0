#include "rigid/free_tops.hpp"

namespace rigid {

double space_precession_rate(double I1, double I3, const Vector3d& omega) {
  return omega.cwiseProduct(Vector3d(I1, I1, I3)).norm() / I1;
}

}  // namespace rigid
