#include <cmath>
#include <rigid/euler_equations.hpp>
Vector3d spin_up(double I1, double I3, const Vector3d& omega0, double torque, double t) {
//! right: sine and cosine
  const double angle = (I3 - I1) / I1 * (omega0[2] * t + 0.5 * torque / I3 * t * t);
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * omega0[0] - s * omega0[1], s * omega0[0] + c * omega0[1], omega0[2] + torque / I3 * t};
//! wrong: no half
-  const double angle = (I3 - I1) / I1 * (omega0[2] * t + 0.5 * torque / I3 * t * t);
+  const double angle = (I3 - I1) / I1 * (omega0[2] * t + torque / I3 * t * t);
//! wrong: passive rotation
-  return {c * omega0[0] - s * omega0[1], s * omega0[0] + c * omega0[1], omega0[2] + torque / I3 * t};
+  return {c * omega0[0] + s * omega0[1], -s * omega0[0] + c * omega0[1], omega0[2] + torque / I3 * t};
//! right: amplitude and phase
  const double omega3 = omega0[2] + torque / I3 * t;
  const double phase = std::atan2(omega0[1], omega0[0]) + (I3 - I1) / I1 * t * (omega0[2] + omega3) / 2;
  const double A = std::hypot(omega0[0], omega0[1]);
  return {A * std::cos(phase), A * std::sin(phase), omega3};
//! wrong: rate of the end
  const double omega3 = omega0[2] + torque / I3 * t, angle = (I3 - I1) / I1 * omega3 * t;
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * omega0[0] - s * omega0[1], s * omega0[0] + c * omega0[1], omega3};
//! wrong: phase lost
  const double angle = (I3 - I1) / I1 * (omega0[2] * t + 0.5 * torque / I3 * t * t);
  const double A = std::hypot(omega0[0], omega0[1]);
  return {A * std::cos(angle), A * std::sin(angle), omega0[2] + torque / I3 * t};
//! wrong: torque not divided by the moment
  const double angle = (I3 - I1) / I1 * (omega0[2] * t + 0.5 * torque * t * t);
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * omega0[0] - s * omega0[1], s * omega0[0] + c * omega0[1], omega0[2] + torque * t};
//! wrong: brackets forgotten
  const double w3 = omega0[2] + torque * t / I3;
  const double a = (I3 - I1 / I1) * (omega0[2] * t + torque * t * t / (2 * I3));
  return {std::cos(a) * omega0[0] - std::sin(a) * omega0[1], std::sin(a) * omega0[0] + std::cos(a) * omega0[1], w3};
//! wrong: torque over the other moment, twice
  const double k = (I3 - I1) / I1;
  const double w3 = omega0[2] + torque * t / I1;
  const double a = k * (omega0[2] * t + torque * t * t / (2 * I1));
  return {std::cos(a) * omega0[0] - std::sin(a) * omega0[1], std::sin(a) * omega0[0] + std::cos(a) * omega0[1], w3};
