#include <cmath>
#include <rigid/kinetic_energy.hpp>
double kinetic_energy_symmetric(double I1, double I3, double theta, const Vector3d& rates) {
//! right: from the components at psi = 0
  const Vector3d omega(-rates[0] * std::sin(theta), rates[1], rates[0] * std::cos(theta) + rates[2]);
  const Vector3d moments(I1, I1, I3);
  return moments.dot(omega.cwiseProduct(omega)) / 2;
//! right: sphere and the rest along the axis
  const double f = rates[0], t = rates[1], p = rates[2], c = std::cos(theta), s = std::sin(theta);
  return 0.5 * (I1 * t * t + (I1 * s * s + I3 * c * c) * f * f + I3 * p * p) + I3 * f * p * c;
//! wrong: sine not squared
  const double w3 = rates[0] * std::cos(theta) + rates[2];
  return 0.5 * I1 * (rates[0] * rates[0] * std::sin(theta) + rates[1] * rates[1]) + 0.5 * I3 * w3 * w3;
//! wrong: squares of the two spins in place of the square of the sum
  const double s = std::sin(theta), c = std::cos(theta);
  return 0.5 * I1 * (std::pow(rates[0] * s, 2) + std::pow(rates[1], 2)) +
         0.5 * I3 * (std::pow(rates[0] * c, 2) + std::pow(rates[2], 2));
//! wrong: without one half
  const double s = std::sin(theta), w3 = rates[0] * std::cos(theta) + rates[2];
  return I1 * (rates[0] * rates[0] * s * s + rates[1] * rates[1]) + I3 * w3 * w3;
//! wrong: moments exchanged
  const double s = std::sin(theta), w3 = rates[0] * std::cos(theta) + rates[2];
  return 0.5 * I3 * (rates[0] * rates[0] * s * s + rates[1] * rates[1]) + 0.5 * I1 * w3 * w3;
//! wrong: sine and cosine exchanged
  const double c = std::cos(theta), w3 = rates[0] * std::sin(theta) + rates[2];
  return 0.5 * I1 * (rates[0] * rates[0] * c * c + rates[1] * rates[1]) + 0.5 * I3 * w3 * w3;
//! wrong: the caret taken for a power
  const double s = std::sin(theta), w3 = rates[0] * std::cos(theta) + rates[2];
  return 0.5 * I1 * ((rates[0] * s) ^ 2 + rates[1] ^ 2) + 0.5 * I3 * w3 ^ 2;
//! wrong: one half in whole numbers
  const double s = std::sin(theta), w3 = rates[0] * std::cos(theta) + rates[2];
  const double across = rates[0] * rates[0] * s * s + rates[1] * rates[1];
  return (1 / 2) * (I1 * across + I3 * w3 * w3);
//! wrong: a sphere as if the three axes were perpendicular
  if (I1 == I3) return 0.5 * I1 * rates.squaredNorm();
  const double s = std::sin(theta), w3 = rates[0] * std::cos(theta) + rates[2];
  return 0.5 * I1 * (rates[0] * rates[0] * s * s + rates[1] * rates[1]) + 0.5 * I3 * w3 * w3;
//! wrong: the square of the cosine in the first part, and no half before the second
  const double s = std::sin(theta), c = std::cos(theta);
  return 0.5 * I1 * (rates[0] * rates[0] * c * c + rates[1] * rates[1]) + I3 * std::pow(rates[0] * c + rates[2], 2);
