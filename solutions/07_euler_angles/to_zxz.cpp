#include "rigid/euler_angles.hpp"

#include <cmath>
#include <numbers>

namespace rigid {

Vector3d to_zxz(const Vector3d& angles) {
  constexpr double pi = std::numbers::pi;
  const auto wrapped = [](double angle) { return std::remainder(angle, 2 * pi); };
  double phi = angles[0] + pi / 2, theta = wrapped(angles[1]), psi = angles[2] - pi / 2;
  if (theta < 0) {  // the same attitude, with the line of nodes the other way round
    phi += pi;
    theta = -theta;
    psi += pi;
  }
  if (std::sin(theta) < 1e-9) {  // ê₃ is upright: both turns are about it, or about its opposite
    phi += theta < 1 ? psi : -psi;
    psi = 0;
  }
  return {wrapped(phi), theta, wrapped(psi)};
}

}  // namespace rigid
