#include "rigid/euler_angles.hpp"

#include <cmath>

namespace rigid {

VectorXd attitude_quaternion(const Vector3d& angles) {
  // (cos φ/2 + k sin φ/2) (cos θ/2 + j sin θ/2) (cos ψ/2 + k sin ψ/2), multiplied out
  const double half_sum = (angles[0] + angles[2]) / 2, half_difference = (angles[2] - angles[0]) / 2;
  const double c = std::cos(angles[1] / 2), s = std::sin(angles[1] / 2);
  return VectorXd{
      {c * std::cos(half_sum), s * std::sin(half_difference), s * std::cos(half_difference), c * std::sin(half_sum)}};
}

}  // namespace rigid
