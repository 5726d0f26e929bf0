#include <cmath>
#include <complex>
#include <rigid/free_tops.hpp>
Vector3d symmetric_top(double I1, double I3, const Vector3d& omega0, double t) {
//! right: amplitude and phase
  const double Omega = omega0[2] * (I3 - I1) / I1;
  const double A = std::hypot(omega0[0], omega0[1]);
  const double delta = std::atan2(omega0[1], omega0[0]);
  return {A * std::cos(Omega * t + delta), A * std::sin(Omega * t + delta), omega0[2]};
//! wrong: phase from atan, which knows no quadrant
-  const double delta = std::atan2(omega0[1], omega0[0]);
+  const double delta = A == 0 ? 0 : std::atan(omega0[1] / omega0[0]);
//! wrong: phase forgotten
  const double Omega = omega0[2] * (I3 - I1) / I1;
  const double A = std::hypot(omega0[0], omega0[1]);
  return {A * std::cos(Omega * t), A * std::sin(Omega * t), omega0[2]};
//! wrong: phase from the arc cosine, undefined without a wobble
  const double Omega = omega0[2] * (I3 - I1) / I1;
  const double A = std::sqrt(omega0[0] * omega0[0] + omega0[1] * omega0[1]);
  const double delta = std::copysign(std::acos(omega0[0] / A), omega0[1]);
  return {A * std::cos(Omega * t + delta), A * std::sin(Omega * t + delta), omega0[2]};
//! right: a complex number turns
  const double Omega = omega0[2] * (I3 - I1) / I1;
  const std::complex<double> w = std::complex<double>(omega0[0], omega0[1]) * std::polar(1.0, Omega * t);
  return {w.real(), w.imag(), omega0[2]};
//! wrong: against the sense of the precession
  const double Omega = omega0[2] * (I3 - I1) / I1;
  return Eigen::AngleAxisd(-Omega * t, Vector3d::UnitZ()) * omega0;
//! wrong: arguments of atan2 exchanged
  const double Omega = omega0.z() * (I3 - I1) / I1;
  const double A = omega0.head<2>().norm();
  const double delta = std::atan2(omega0.x(), omega0.y());
  return {A * std::cos(Omega * t + delta), A * std::sin(Omega * t + delta), omega0.z()};
//! wrong: divided by the other moment
  const double angle = omega0[2] * (I3 - I1) / I3 * t;
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega0;
//! wrong: the rate in space, L over I1
  const double rate = Vector3d(I1 * omega0[0], I1 * omega0[1], I3 * omega0[2]).norm() / I1;
  return Eigen::AngleAxisd(rate * t, Vector3d::UnitZ()) * omega0;
//! wrong: the third component is never set
  Vector3d omega;
  const double angle = omega0[2] * (I3 - I1) / I1 * t;
  omega[0] = omega0[0] * std::cos(angle) - omega0[1] * std::sin(angle);
  omega[1] = omega0[0] * std::sin(angle) + omega0[1] * std::cos(angle);
  return omega;
//! wrong: nothing moves before time 0
  if (t < 0) return omega0;
  const double angle = omega0[2] * (I3 - I1) / I1 * t;
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega0;
//! wrong: amplitude of the wobble from all of omega
  const double rate = omega0[2] * (I3 - I1) / I1, A = omega0.norm(), d = std::atan2(omega0[1], omega0[0]);
  return {A * std::cos(rate * t + d), A * std::sin(rate * t + d), omega0[2]};
