#include <cmath>
#include <rigid/kinetic_energy.hpp>
double kinetic_energy_euler(const Vector3d& I, const Vector3d& angles, const Vector3d& rates) {
//! right: squares written out
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const double f = rates[0], t = rates[1], p = rates[2];
  return 0.5 * f * f * (s * s * (I[0] * cp * cp + I[1] * sp * sp) + I[2] * c * c) +
         0.5 * t * t * (I[0] * sp * sp + I[1] * cp * cp) + 0.5 * I[2] * p * p + f * t * (I[1] - I[0]) * s * sp * cp +
         I[2] * f * p * c;
//! right: in inertial components
  using Eigen::AngleAxisd;
  const Matrix3d A = (AngleAxisd(angles[0], Vector3d::UnitZ()) * AngleAxisd(angles[1], Vector3d::UnitY()) *
                      AngleAxisd(angles[2], Vector3d::UnitZ()))
                         .toRotationMatrix();
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sf = std::sin(angles[0]), cf = std::cos(angles[0]);
  const Vector3d omega(-rates[1] * sf + rates[2] * s * cf, rates[1] * cf + rates[2] * s * sf, rates[0] + rates[2] * c);
  const Matrix3d tensor = A * I.asDiagonal() * A.transpose();
  return omega.dot(tensor * omega) / 2;
//! wrong: z-x-z of the other books
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const double w1 = rates[0] * s * sp + rates[1] * cp, w2 = rates[0] * s * cp - rates[1] * sp;
  const double w3 = rates[0] * c + rates[2];
  return 0.5 * (I[0] * w1 * w1 + I[1] * w2 * w2 + I[2] * w3 * w3);
//! wrong: sign of the first term
-  const double w1 = rates[0] * s * sp + rates[1] * cp, w2 = rates[0] * s * cp - rates[1] * sp;
+  const double w1 = rates[0] * s * cp + rates[1] * sp, w2 = rates[0] * s * sp + rates[1] * cp;
//! wrong: formula of the symmetric top
  const double s = std::sin(angles[1]), c = std::cos(angles[1]);
  const double w3 = rates[0] * c + rates[2];
  return 0.5 * I[0] * (rates[0] * rates[0] * s * s + rates[1] * rates[1]) + 0.5 * I[2] * w3 * w3;
//! wrong: one half in whole numbers
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const double w1 = -rates[0] * s * cp + rates[1] * sp, w2 = rates[0] * s * sp + rates[1] * cp;
  const double w3 = rates[0] * c + rates[2];
  return 1 / 2 * (I[0] * std::pow(w1, 2) + I[1] * std::pow(w2, 2) + I[2] * std::pow(w3, 2));
//! wrong: without one half
-  return 1 / 2 * (I[0] * std::pow(w1, 2) + I[1] * std::pow(w2, 2) + I[2] * std::pow(w3, 2));
+  return I[0] * w1 * w1 + I[1] * w2 * w2 + I[2] * w3 * w3;
//! wrong: rates as components
  return 0.5 * I.dot(rates.cwiseAbs2());
//! wrong: phi in place of psi
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[0]), cp = std::cos(angles[0]);
  const double w1 = -rates[0] * s * cp + rates[1] * sp, w2 = rates[0] * s * sp + rates[1] * cp;
  const double w3 = rates[0] * c + rates[2];
  return 0.5 * (I[0] * w1 * w1 + I[1] * w2 * w2 + I[2] * w3 * w3);
