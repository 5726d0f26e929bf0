#include <cmath>
#include <rigid/free_tops.hpp>
double space_precession_rate(double I1, double I3, const Vector3d& omega) {
//! right: across and along
  const double across = std::hypot(omega[0], omega[1]);
  return std::hypot(across, I3 / I1 * omega[2]);
//! right: sum of squares
  const double L1 = I1 * omega[0], L2 = I1 * omega[1], L3 = I3 * omega[2];
  return std::sqrt(L1 * L1 + L2 * L2 + L3 * L3) / I1;
//! wrong: the length of omega
double space_precession_rate(double I1, double I3, const Vector3d& omega) { return omega.norm(); }
//! wrong: divided by the other moment
  return Vector3d(I1 * omega[0], I1 * omega[1], I3 * omega[2]).norm() / I3;
//! wrong: only the part along the symmetry axis
double space_precession_rate(double I1, double I3, const Vector3d& omega) { return I3 * omega[2] / I1; }
//! wrong: square not drawn
  return (I1 * I1 * (omega[0] * omega[0] + omega[1] * omega[1]) + I3 * I3 * omega[2] * omega[2]) / I1;
//! wrong: moments not squared
  const double L = std::sqrt(I1 * omega[0] * omega[0] + I1 * omega[1] * omega[1] + I3 * omega[2] * omega[2]);
  return L / I1;
//! wrong: sign of the spin
  const double L = Vector3d(I1 * omega[0], I1 * omega[1], I3 * omega[2]).norm();
  return omega[2] < 0 ? -L / I1 : L / I1;
//! wrong: from the angle of the cone, undefined without a spin
  const Vector3d L(I1 * omega[0], I1 * omega[1], I3 * omega[2]);
  const double cosine = L[2] / L.norm();
  return I3 * omega[2] / (I1 * cosine);
//! wrong: no precession without a wobble
  if (omega[0] == 0 && omega[1] == 0) return 0;
  return Vector3d(I1 * omega[0], I1 * omega[1], I3 * omega[2]).norm() / I1;
//! wrong: angle between the axis and omega in place of L
  if (omega[2] == 0) return omega.norm();
  const double cos_theta = std::abs(omega[2]) / omega.norm();
  return I3 * std::abs(omega[2]) / (I1 * cos_theta);
