#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/kinetic_energy.hpp>
double hamiltonian(const Vector3d& I, const Vector3d& angles, const Vector3d& momenta) {
//! right: components of L in the body from the momenta
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), S = std::sin(angles[2]), C = std::cos(angles[2]);
  const double x = (momenta[0] - momenta[2] * c) / s;
  const double L1 = -x * C + momenta[1] * S, L2 = x * S + momenta[1] * C;
  return L1 * L1 / (2 * I[0]) + L2 * L2 / (2 * I[1]) + momenta[2] * momenta[2] / (2 * I[2]);
//! wrong: I1 and I2 exchanged
-  return L1 * L1 / (2 * I[0]) + L2 * L2 / (2 * I[1]) + momenta[2] * momenta[2] / (2 * I[2]);
+  return L1 * L1 / (2 * I[1]) + L2 * L2 / (2 * I[0]) + momenta[2] * momenta[2] / (2 * I[2]);
//! wrong: one half missing
-  return L1 * L1 / (2 * I[0]) + L2 * L2 / (2 * I[1]) + momenta[2] * momenta[2] / (2 * I[2]);
+  return L1 * L1 / (2 * I[0]) + L2 * L2 / (2 * I[1]) + momenta[2] * momenta[2] / I[2];
//! wrong: sign of p_psi cos theta
-  const double x = (momenta[0] - momenta[2] * c) / s;
+  const double x = (momenta[0] + momenta[2] * c) / s;
//! wrong: phi in place of psi
-  const double s = std::sin(angles[1]), c = std::cos(angles[1]), S = std::sin(angles[2]), C = std::cos(angles[2]);
+  const double s = std::sin(angles[1]), c = std::cos(angles[1]), S = std::sin(angles[0]), C = std::cos(angles[0]);
//! wrong: divided by sine twice
-  const double x = (momenta[0] - momenta[2] * c) / s;
+  const double x = (momenta[0] - momenta[2] * c) / s / s;
//! wrong: momenta as body components
  return (momenta.cwiseAbs2().array() / I.array()).sum() / 2;
//! wrong: multiplied by the third moment
  const double st = std::sin(angles(1)), ct = std::cos(angles(1)), sp = std::sin(angles(2)), cp = std::cos(angles(2));
  const double q = (momenta(0) - momenta(2) * ct) / st;
  const double l1 = -q * cp + momenta(1) * sp;
  const double l2 = q * sp + momenta(1) * cp;
  return l1 * l1 / (2 * I(0)) + l2 * l2 / (2 * I(1)) + I(2) * momenta(2) * momenta(2) / 2;
//! wrong: entries of the matrix inverted
  const double st = std::sin(angles[1]), ct = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  Matrix3d B;
  B << -st * cp, sp, 0, st * sp, cp, 0, ct, 0, 1;
  const Matrix3d M = B.transpose() * I.asDiagonal() * B;
  double H = 0;
  for (int k = 0; k < 3; ++k) H += momenta[k] * momenta[k] / (2 * M(k, k));
  return H;
