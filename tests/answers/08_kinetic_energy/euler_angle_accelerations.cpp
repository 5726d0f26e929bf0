#include <cmath>
#include <complex>
#include <rigid/kinetic_energy.hpp>
Vector3d euler_angle_accelerations(const Vector3d& I, const Vector3d& angles, const Vector3d& rates) {
//! right: on axes that follow the line of nodes
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const double f = rates[0], t = rates[1], p = rates[2];
  const Vector3d w(-f * s * cp + t * sp, f * s * sp + t * cp, f * c + p);
  const Vector3d a_body = I.cwiseProduct(w).cross(w).cwiseQuotient(I);
  const Vector3d a = Eigen::AngleAxisd(angles[2], Vector3d::UnitZ()) * a_body;
  const Vector3d frame(-f * s, t, f * c);
  const Vector3d relative = a - frame.cross(frame + p * Vector3d::UnitZ());
  const double ff = -(relative[0] + f * t * c) / s;
  return {ff, relative[1], relative[2] - ff * c + f * s * t};
//! right: the matrix of the axes and its rate
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const double t = rates[1], p = rates[2];
  Matrix3d B, B_rate;
  B << -s * cp, sp, 0, s * sp, cp, 0, c, 0, 1;
  B_rate << -c * cp * t + s * sp * p, cp * p, 0, c * sp * t + s * cp * p, -sp * p, 0, -s * t, 0, 0;
  const Vector3d w = B * rates;
  const Vector3d w_rate = -w.cross(I.cwiseProduct(w)).cwiseQuotient(I);
  return B.fullPivLu().solve(w_rate - B_rate * rates);
//! wrong: Euler's equations not divided by the moments
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const double f = rates[0], t = rates[1], p = rates[2];
  const Vector3d w(-f * s * cp + t * sp, f * s * sp + t * cp, f * c + p);
  const Vector3d w_rate = -w.cross(I.cwiseProduct(w));
  const Vector3d turning(-f * t * c * cp + f * p * s * sp + t * p * cp, f * t * c * sp + f * p * s * cp - t * p * sp,
                         -f * t * s);
  const Vector3d a = w_rate - turning;
  const double phi = (-a[0] * cp + a[1] * sp) / s;
  return {phi, a[0] * sp + a[1] * cp, a[2] - c * phi};
//! wrong: sign of Euler's equations
-  const Vector3d w_rate = -w.cross(I.cwiseProduct(w));
+  const Vector3d w_rate = w.cross(I.cwiseProduct(w)).cwiseQuotient(I);
@@
-  const Vector3d a = w_rate - turning;
+  const Vector3d a = w_rate + (-1) * turning;
//! wrong: the turning of the axes with the other sign
-  const Vector3d w_rate = -w.cross(I.cwiseProduct(w));
+  const Vector3d w_rate = w.cross(-I.cwiseProduct(w)).cwiseQuotient(I);
@@
-  const Vector3d a = w_rate - turning;
+  const Vector3d a = w_rate + turning;
//! wrong: only one of the terms of the turning line of nodes
-  const Vector3d w_rate = -w.cross(I.cwiseProduct(w));
-  const Vector3d turning(-f * t * c * cp + f * p * s * sp + t * p * cp, f * t * c * sp + f * p * s * cp - t * p * sp,
-                         -f * t * s);
+  const Vector3d w_rate = -w.cross(I.cwiseProduct(w)).cwiseQuotient(I);
+  const Vector3d turning(-f * t * c * cp + f * p * s * sp, f * t * c * sp + f * p * s * cp, -f * t * s);
//! wrong: the axes are taken to stand still
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d w(-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]);
  const Vector3d a = -w.cross(I.cwiseProduct(w)).cwiseQuotient(I);
  const double phi = (-a[0] * cp + a[1] * sp) / s;
  return {phi, a[0] * sp + a[1] * cp, a[2] - c * phi};
//! wrong: Lagrange's equation without the derivative of the energy
  const double s = std::sin(angles[1]), c = std::cos(angles[1]), sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  Matrix3d B, dB;
  B << -s * cp, sp, 0, s * sp, cp, 0, c, 0, 1;
  dB << -c * cp * rates[1] + s * sp * rates[2], cp * rates[2], 0, c * sp * rates[1] + s * cp * rates[2], -sp * rates[2],
      0, -s * rates[1], 0, 0;
  const Matrix3d M = B.transpose() * I.asDiagonal() * B;
  const Matrix3d dM = dB.transpose() * I.asDiagonal() * B + B.transpose() * I.asDiagonal() * dB;
  return -M.inverse() * dM * rates;
//! right: rate of the matrix by a complex step
  using C = std::complex<double>;
  const auto B = [](C th, C ps) {
    Eigen::Matrix3cd m;
    m << -std::sin(th) * std::cos(ps), std::sin(ps), 0, std::sin(th) * std::sin(ps), std::cos(ps), 0, std::cos(th), 0, 1;
    return m;
  };
  const double h = 1e-150;
  const Eigen::Matrix3cd now = B(angles[1], angles[2]), later = B(C(angles[1], h * rates[1]), C(angles[2], h * rates[2]));
  const Matrix3d b = now.real(), db = later.imag() / h;
  const Vector3d w = b * rates, a = I.cwiseProduct(w).cross(w).cwiseQuotient(I);
  return b.partialPivLu().solve(a - db * rates);
//! wrong: forward differences for the rates of the axes
  const auto B = [](const Vector3d& q) {
    const double st = std::sin(q[1]), ct = std::cos(q[1]), sp = std::sin(q[2]), cp = std::cos(q[2]);
    Matrix3d m;
    m << -st * cp, sp, 0, st * sp, cp, 0, ct, 0, 1;
    return m;
  };
  const double h = 1e-6;
  const Matrix3d D = (B(angles + h * rates) - B(angles)) / h;
  const Vector3d w = B(angles) * rates;
  const Vector3d a = -w.cross(I.cwiseProduct(w)).cwiseQuotient(I);
  return B(angles).inverse() * (a - D * rates);
