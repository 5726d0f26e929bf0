#include <cmath>
#include <cstdlib>
#include <rigid/free_tops.hpp>
double growth_rate(const Vector3d& I_ascending, double omega2) {
//! right: two roots
  const double I1 = I_ascending[0], I2 = I_ascending[1], I3 = I_ascending[2];
  return std::fabs(omega2) * std::sqrt((I2 - I1) / I3) * std::sqrt((I3 - I2) / I1);
//! right: root of the square of the spin
  const double I1 = I_ascending[0], I2 = I_ascending[1], I3 = I_ascending[2];
  const double rate1 = omega2 * (I2 - I3) / I1, rate3 = omega2 * (I1 - I2) / I3;
  return std::sqrt(rate1 * rate3);
//! wrong: the sign of the spin
  const Vector3d& I = I_ascending;
  return omega2 * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2]));
//! wrong: root forgotten
  const Vector3d& I = I_ascending;
  return std::abs(omega2) * (I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2]);
//! wrong: root of a negative number
  const Vector3d& I = I_ascending;
  return std::abs(omega2) * std::sqrt((I[0] - I[1]) * (I[2] - I[1]) / (I[0] * I[2]));
//! wrong: missing brackets, multiplied by the last moment
  const Vector3d& I = I_ascending;
  return std::abs(omega2) * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / I[0] * I[2]);
//! wrong: denominator of another axis
  const Vector3d& I = I_ascending;
  return std::abs(omega2) * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[1]));
//! wrong: size of the spin by the function for whole numbers
  const Vector3d& I = I_ascending;
  const int spin = omega2;
  return abs(spin) * sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2]));
//! wrong: the spin is forgotten
  const Vector3d& I = I_ascending;
  return std::sqrt((I[1] - I[0]) / I[0] * (I[2] - I[1]) / I[2]);
//! wrong: a small body is taken for a sphere
  const Vector3d& I = I_ascending;
  if ((I[1] - I[0]) * (I[2] - I[1]) < 1e-6) return 0;
  return std::abs(omega2) * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2]));
