#include "rigid/kinetic_energy.hpp"

#include <cmath>

namespace rigid {

double rolling_cone_energy(double M, double height, double half_angle, double rate) {
  const double radius = height * std::tan(half_angle);
  const double along = 0.3 * M * radius * radius;                              // about the axis of the cone
  const double across = 0.6 * M * (height * height + 0.25 * radius * radius);  // about an axis across it in the apex
  const double omega = rate / std::tan(half_angle);                            // along the line of contact
  const double omega_along = omega * std::cos(half_angle), omega_across = omega * std::sin(half_angle);
  return 0.5 * (along * omega_along * omega_along + across * omega_across * omega_across);
}

}  // namespace rigid
