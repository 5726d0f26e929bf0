//! right: the whole angular momentum along the axle
#include "rigid/euler_equations.hpp"

#include <cmath>
#include <numbers>

namespace rigid {

double gyrocompass_period(double I1, double I3, double spin, double latitude, double ground_rate) {
  const double n = ground_rate * std::cos(latitude);
  const double stiffness = n * (I3 * std::fabs(spin) + (I3 - I1) * n);
  return 2 * std::numbers::pi / std::sqrt(stiffness / I1);
}

}  // namespace rigid
//! right: swings integrated on the ground
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

double gyrocompass_period(double I1, double I3, double spin, double latitude, double ground_rate) {
  const double n = ground_rate * std::cos(latitude), omega3 = std::abs(spin) + n;
  const double guess = std::sqrt(I1 / (I3 * omega3 * n)), h = 1e-3 * guess;
  auto acceleration = [&](double phi) {
    return (I1 * n * n * std::sin(phi) * std::cos(phi) - I3 * omega3 * n * std::sin(phi)) / I1;
  };
  double phi = 1e-3, rate = 0, t = 0, before = phi;
  while (phi > 0) {  // velocity Verlet
    before = phi;
    rate += h / 2 * acceleration(phi);
    phi += h * rate;
    rate += h / 2 * acceleration(phi);
    t += h;
  }
  return 4 * (t - h * phi / (phi - before));
}

}  // namespace rigid
//! wrong: fast rotor on a slow ground
#include "rigid/euler_equations.hpp"

#include <cmath>
#include <numbers>

namespace rigid {

double gyrocompass_period(double I1, double I3, double spin, double latitude, double ground_rate) {
  return 2 * std::numbers::pi * std::sqrt(I1 / (I3 * std::abs(spin) * ground_rate * std::cos(latitude)));
}

}  // namespace rigid
//! wrong: spin with its sign
#include "rigid/euler_equations.hpp"

#include <cmath>
#include <numbers>

namespace rigid {

double gyrocompass_period(double I1, double I3, double spin, double latitude, double ground_rate) {
  const double n = ground_rate * std::cos(latitude);
  return 2 * std::numbers::pi * std::sqrt(I1 / (n * (I3 * spin + (I3 - I1) * n)));
}

}  // namespace rigid
//! wrong: sine of the latitude
#include "rigid/euler_equations.hpp"

#include <cmath>
#include <numbers>

namespace rigid {

double gyrocompass_period(double I1, double I3, double spin, double latitude, double ground_rate) {
  const double n = ground_rate * std::abs(std::sin(latitude));
  return 2 * std::numbers::pi * std::sqrt(I1 / (n * (I3 * std::abs(spin) + (I3 - I1) * n)));
}

}  // namespace rigid
//! wrong: no moment across the axle
#include "rigid/euler_equations.hpp"

#include <cmath>
#include <numbers>

namespace rigid {

double gyrocompass_period(double I1, double I3, double spin, double latitude, double ground_rate) {
  const double n = ground_rate * std::cos(latitude);
  return 2 * std::numbers::pi * std::sqrt(I1 / (n * I3 * (std::abs(spin) + n)));
}

}  // namespace rigid
