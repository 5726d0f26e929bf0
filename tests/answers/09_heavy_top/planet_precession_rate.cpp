#include <cmath>
#include <numbers>
#include <rigid/heavy_top.hpp>
double planet_precession_rate(double I1, double I3, double spin, double orbital_rate, double obliquity) {
//! right: torque summed over a year
  const Vector3d axis(std::sin(obliquity), 0, std::cos(obliquity));
  const Matrix3d inertia = I1 * Matrix3d::Identity() + (I3 - I1) * axis * axis.transpose();
  Vector3d torque = Vector3d::Zero();
  const int n = 12;
  for (int month = 0; month < n; ++month) {
    const double angle = 2 * std::numbers::pi * month / n;
    const Vector3d sun(std::cos(angle), std::sin(angle), 0);
    torque += 3 * orbital_rate * orbital_rate / n * sun.cross(inertia * sun);
  }
  // dL/dt = rate × L about the normal z: with L = I3 spin axis its y component is rate · L_x
  return torque.y() / (I3 * spin * axis.x());
//! right: ring of the smeared sun, change of its energy with the obliquity
  // mean potential energy n² (I3 − I1)·(3 cos²ε − 1)/4·(−1), φ̇ = −(1/(L sin ε)) dV/dε with the sign of a top that hangs
  const double L = I3 * spin, n2 = orbital_rate * orbital_rate;
  const double slope = 1.5 * n2 * (I3 - I1) * std::sin(obliquity) * std::cos(obliquity);
  return -slope / (L * std::sin(obliquity));
//! wrong: three halves in whole numbers
  return -3 / 2 * (orbital_rate * orbital_rate / spin) * ((I3 - I1) / I3) * std::cos(obliquity);
//! wrong: sense of the orbital motion
  return 1.5 * orbital_rate * orbital_rate / spin * (I3 - I1) / I3 * std::cos(obliquity);
//! wrong: always backwards, even where the planet rotates backwards
  return -1.5 * orbital_rate * orbital_rate / spin * (I3 - I1) / I3 * std::abs(std::cos(obliquity));
//! wrong: sine of the obliquity
  return -1.5 * orbital_rate * orbital_rate / spin * (I3 - I1) / I3 * std::sin(obliquity);
//! wrong: rates exchanged
  return -1.5 * spin * spin / orbital_rate * (I3 - I1) / I3 * std::cos(obliquity);
//! wrong: the sun always over the solstice
  return -3 * orbital_rate * orbital_rate / spin * (I3 - I1) / I3 * std::cos(obliquity);
//! wrong: torque over all of L, not over its level part
  return -0.75 * orbital_rate * orbital_rate / spin * (I3 - I1) / I3 * std::sin(2 * obliquity);
//! wrong: flattening over I1
  return -1.5 * orbital_rate * orbital_rate / spin * (I3 - I1) / I1 * std::cos(obliquity);
//! wrong: not divided by the spin
  return -1.5 * orbital_rate * orbital_rate * (I3 - I1) / I3 * std::cos(obliquity);
