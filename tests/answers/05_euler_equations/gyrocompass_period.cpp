#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/euler_equations.hpp>
double gyrocompass_period(double I1, double I3, double spin, double latitude, double ground_rate) {
//! right: the whole angular momentum along the axle
  const double n = ground_rate * std::cos(latitude);
  const double stiffness = n * (I3 * std::fabs(spin) + (I3 - I1) * n);
  return 2 * std::numbers::pi / std::sqrt(stiffness / I1);
//! wrong: spin with its sign
  const double n = ground_rate * std::cos(latitude);
  return 2 * std::numbers::pi * std::sqrt(I1 / (n * (I3 * spin + (I3 - I1) * n)));
//! wrong: no moment across the axle
  const double n = ground_rate * std::cos(latitude);
  return 2 * std::numbers::pi * std::sqrt(I1 / (n * I3 * (std::abs(spin) + n)));
//! right: swings integrated on the ground
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
//! wrong: fast rotor on a slow ground
  return 2 * std::numbers::pi * std::sqrt(I1 / (I3 * std::abs(spin) * ground_rate * std::cos(latitude)));
//! wrong: sine of the latitude
  const double n = ground_rate * std::abs(std::sin(latitude));
  return 2 * std::numbers::pi * std::sqrt(I1 / (n * (I3 * std::abs(spin) + (I3 - I1) * n)));
