#include "rigid/euler_equations.hpp"

#include <cmath>
#include <numbers>

namespace rigid {

double gyrocompass_period(double I1, double I3, double spin, double latitude, double ground_rate) {
  // Stable is the direction in which the rotor turns in the same sense as the ground: with a negative spin, south.
  const double level = ground_rate * std::cos(latitude), L = I3 * (std::abs(spin) + level);
  // About the vertical, the axle at the angle φ from there: I1 φ″ = −L level sin φ + I1 level² sin φ cos φ
  return 2 * std::numbers::pi * std::sqrt(I1 / (level * (L - I1 * level)));
}

}  // namespace rigid
