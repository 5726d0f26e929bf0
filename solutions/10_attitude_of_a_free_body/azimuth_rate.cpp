#include "rigid/attitude_of_a_free_body.hpp"

namespace rigid {

double azimuth_rate(const Vector3d& I, const Vector3d& omega) {
  // The third axis has dropped out of numerator and denominator: nothing cancels where it is close to L.
  const Vector3d L = I.cwiseProduct(omega);
  return L.norm() * L.head<2>().dot(omega.head<2>()) / L.head<2>().squaredNorm();
}

}  // namespace rigid
