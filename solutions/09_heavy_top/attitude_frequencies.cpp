#include "rigid/heavy_top.hpp"

#include <cmath>

namespace rigid {

Vector3d attitude_frequencies(const Vector3d& I, double orbital_rate) {
  // In units of the orbital rate: σ⁴ − (1 + 3 roll + roll yaw) σ² + 4 roll yaw = 0 across the plane of the orbit
  const double pitch = (I[1] - I[0]) / I[2], roll = (I[2] - I[0]) / I[1], yaw = (I[2] - I[1]) / I[0];
  const double half_sum = (1 + 3 * roll + roll * yaw) / 2, product = 4 * roll * yaw;
  const double faster = half_sum + std::sqrt(half_sum * half_sum - product);
  return orbital_rate * Vector3d(3 * pitch, product / faster, faster).cwiseSqrt();
}

}  // namespace rigid
