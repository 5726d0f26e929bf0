#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/kinetic_energy.hpp>
double rolling_cone_energy(double M, double height, double half_angle, double rate) {
//! right: about the tip
  const double R = height * std::tan(half_angle);
  const double A = 0.3 * M * R * R, B = 0.6 * M * (height * height + R * R / 4);
  const double w = rate / std::tan(half_angle);
  return 0.5 * (A * std::pow(w * std::cos(half_angle), 2) + B * std::pow(w * std::sin(half_angle), 2));
//! wrong: inertia of a cylinder along
-  const double A = 0.3 * M * R * R, B = 0.6 * M * (height * height + R * R / 4);
+  const double A = 0.5 * M * R * R, B = 0.6 * M * (height * height + R * R / 4);
//! wrong: rate times tangent
-  const double w = rate / std::tan(half_angle);
+  const double w = rate * std::tan(half_angle);
//! wrong: about the centre of mass
-  const double A = 0.3 * M * R * R, B = 0.6 * M * (height * height + R * R / 4);
+  const double A = 0.3 * M * R * R, B = 3.0 / 80 * M * (height * height + 4 * R * R);
//! wrong: integer fraction
-  const double A = 0.3 * M * R * R, B = 0.6 * M * (height * height + R * R / 4);
+  const double A = 3 / 10 * M * R * R, B = 0.6 * M * (height * height + R * R / 4);
//! wrong: the spin relative to the moving plane, without the part of the precession along the axis
  const double R = height * std::tan(half_angle);
  const double I3 = 3 * M * R * R / 10, I1 = 3 * M / 5 * (R * R / 4 + height * height);
  const double spin = rate / std::sin(half_angle), across = rate * std::cos(half_angle);
  return I3 * spin * spin / 2 + I1 * across * across / 2;
//! wrong: half angle forgotten as full
  const double a = half_angle / 2;
  const double R = height * std::tan(a);
  const double A = 0.3 * M * R * R, B = 0.6 * M * (height * height + R * R / 4);
  const double w = rate / std::tan(a);
  return 0.5 * (A * std::pow(w * std::cos(a), 2) + B * std::pow(w * std::sin(a), 2));
//! wrong: spin along, rate across
  const double R = height * std::tan(half_angle);
  const double spin = rate / std::sin(half_angle);
  const double I3 = 3 * M * R * R / 10, I1 = 3 * M / 5 * (R * R / 4 + height * height);
  return I3 * spin * spin / 2 + I1 * rate * rate * std::pow(std::cos(half_angle), 2) / 2;
//! wrong: a conical shell
  const double R = height * std::tan(half_angle);
  const double I3 = M * R * R / 2, I1 = M * (R * R / 4 + height * height / 2);
  const double w = rate / std::tan(half_angle);
  return 0.5 * w * w * (I3 * std::pow(std::cos(half_angle), 2) + I1 * std::pow(std::sin(half_angle), 2));
