#include "rigid/euler_angles.hpp"

#include <cmath>

namespace rigid {

Vector3d vertical_in_body(double theta, double psi) {
  return {-std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta)};
}

}  // namespace rigid
