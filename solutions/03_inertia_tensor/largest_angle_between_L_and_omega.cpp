#include "rigid/inertia_tensor.hpp"

#include <cmath>

namespace rigid {

double largest_angle_between_L_and_omega(const Vector3d& I) {
  // The axis lies between those of the extreme moments. From sine and cosine, so that no digits are lost near 0 and
  // π/2.
  const double smallest = I.minCoeff(), largest = I.maxCoeff();
  return std::atan2(largest - smallest, 2 * std::sqrt(smallest) * std::sqrt(largest));
}

}  // namespace rigid
