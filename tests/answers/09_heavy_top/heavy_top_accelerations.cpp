#include <cmath>
#include <rigid/heavy_top.hpp>
Vector3d heavy_top_accelerations(const Vector3d& I, double mgl, const Vector3d& angles, const Vector3d& rates) {
//! right: Euler's equations, then the derivatives of omega along and across the line of nodes
  const double s = std::sin(angles[1]), c = std::cos(angles[1]);
  const double sp = std::sin(angles[2]), cp = std::cos(angles[2]);
  const Vector3d w(-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]);
  const Vector3d torque(mgl * s * sp, mgl * s * cp, 0);
  const Vector3d dw = (torque - w.cross(I.cwiseProduct(w))).cwiseQuotient(I);
  const double theta = dw[0] * sp + dw[1] * cp - rates[2] * rates[0] * s;
  const double phi = (-dw[0] * cp + dw[1] * sp + rates[2] * rates[1] - rates[0] * rates[1] * c) / s;
  return {phi, theta, dw[2] - phi * c + rates[0] * rates[1] * s};
//! wrong: the torque always about the second axis of the body
-  const Vector3d torque(mgl * s * sp, mgl * s * cp, 0);
+  const Vector3d torque(0, mgl * s, 0);
//! wrong: sine and cosine of psi exchanged in the torque
-  const Vector3d torque(mgl * s * sp, mgl * s * cp, 0);
+  const Vector3d torque(mgl * s * cp, mgl * s * sp, 0);
//! wrong: mgl cos θ for the torque
-  const Vector3d torque(mgl * s * sp, mgl * s * cp, 0);
+  const Vector3d torque = mgl * c * Vector3d(sp, cp, 0);
//! wrong: L omega in place of omega L
-  const Vector3d torque(mgl * s * sp, mgl * s * cp, 0);
-  const Vector3d dw = (torque - w.cross(I.cwiseProduct(w))).cwiseQuotient(I);
+  const Vector3d L = I.cwiseProduct(w);
+  const Vector3d dw = (mgl * s * Vector3d(sp, cp, 0) - L.cross(w)).cwiseQuotient(I);
//! wrong: the third component is never set
-  const Vector3d w(-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]);
-  const Vector3d torque(mgl * s * sp, mgl * s * cp, 0);
+  Vector3d w(-rates[0] * s * cp + rates[1] * sp, rates[0] * s * sp + rates[1] * cp, rates[0] * c + rates[2]);
+  Vector3d torque;
+  torque[0] = mgl * s * sp;
+  torque[1] = mgl * s * cp;
//! wrong: the rates of the axes of Euler are forgotten for phi
-  const double phi = (-dw[0] * cp + dw[1] * sp + rates[2] * rates[1] - rates[0] * rates[1] * c) / s;
+  const double phi = (-dw[0] * cp + dw[1] * sp) / s;
//! right: all vectors in space
  const Vector3d up(0, 0, 1), nodes(-std::sin(angles[0]), std::cos(angles[0]), 0);
  const Matrix3d A = (Eigen::AngleAxisd(angles[0], Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(angles[1], Vector3d::UnitY()) * Eigen::AngleAxisd(angles[2], Vector3d::UnitZ()))
                         .toRotationMatrix();
  const Vector3d axis = A.col(2);
  Matrix3d E;
  E << up, nodes, axis;
  const Vector3d w = E * rates;
  const Matrix3d inertia = A * I.asDiagonal() * A.transpose();
  const Matrix3d inverse = A * I.cwiseInverse().asDiagonal() * A.transpose();
  const Vector3d dw = inverse * (mgl * up.cross(axis) - w.cross(inertia * w));
  const Vector3d moving = rates[1] * rates[0] * up.cross(nodes) + rates[2] * w.cross(axis);
  return E.inverse() * (dw - moving);
//! wrong: a symmetric top
  const double s = std::sin(angles[1]), c = std::cos(angles[1]);
  const double spin = rates[0] * c + rates[2];
  const double theta = s * (c * rates[0] * rates[0] - (I[2] * spin * rates[0] - mgl) / I[0]);
  const double phi = (I[2] * spin / I[0] - 2 * c * rates[0]) * rates[1] / s;
  return {phi, theta, rates[0] * rates[1] * s - phi * c};
