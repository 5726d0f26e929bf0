#include <cmath>
#include <rigid/kinetic_energy.hpp>
Vector3d canonical_momenta(const Vector3d& I, const Vector3d& angles, const Vector3d& rates) {
//! right: three projections
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const double L1 = I[0] * (-rates[0] * s * cp + rates[1] * sp), L2 = I[1] * (rates[0] * s * sp + rates[1] * cp);
  const double L3 = I[2] * (rates[0] * c + rates[2]);
  return {-L1 * s * cp + L2 * s * sp + L3 * c, L1 * sp + L2 * cp, L3};
//! wrong: order, p_psi first
-  return {-L1 * s * cp + L2 * s * sp + L3 * c, L1 * sp + L2 * cp, L3};
+  return {L3, L1 * sp + L2 * cp, -L1 * s * cp + L2 * s * sp + L3 * c};
//! wrong: the part along the axis is missing in p_phi
-  return {-L1 * s * cp + L2 * s * sp + L3 * c, L1 * sp + L2 * cp, L3};
+  return {s * (L2 * sp - L1 * cp), L1 * sp + L2 * cp, L3};
//! wrong: upright the vertical momentum is taken for zero
   const double L3 = I[2] * (rates[0] * c + rates[2]);
+  if (std::abs(s) < 1e-9) return {0, L1 * sp + L2 * cp, L3};
//! right: matrix of the masses
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  Matrix3d M;
  M(0, 0) = s * s * (I[0] * cp * cp + I[1] * sp * sp) + I[2] * c * c;
  M(0, 1) = M(1, 0) = (I[1] - I[0]) * s * sp * cp;
  M(0, 2) = M(2, 0) = I[2] * c;
  M(1, 1) = I[0] * sp * sp + I[1] * cp * cp;
  M(1, 2) = M(2, 1) = 0;
  M(2, 2) = I[2];
  return M * rates;
//! wrong: components on the body axes
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d omega(-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]);
  return I.cwiseProduct(omega);
//! wrong: matrix not transposed
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  Matrix3d B;
  B << -s * cp, sp, 0, s * sp, cp, 0, c, 0, 1;
  return B * I.cwiseProduct(B * rates);
//! wrong: moments times rates
  return I.cwiseProduct(rates);
//! wrong: formula of the symmetric top
  const double s = std::sin(angles[1]), c = std::cos(angles[1]);
  const double L3 = I[2] * (rates[0] * c + rates[2]);
  return {I[0] * s * s * rates[0] + L3 * c, I[0] * rates[1], L3};
