#include <rigid/parallel_axis.hpp>
Matrix3d inertia_from_center_of_mass(const Matrix3d& I_cm, double M, const Vector3d& d) {
//! right: componentwise
  const double x = d.x(), y = d.y(), z = d.z();
  Matrix3d J;
  J << y * y + z * z, -x * y, -x * z, -x * y, x * x + z * z, -y * z, -x * z, -y * z, x * x + y * y;
  return I_cm + M * J;
//! right: the square of the matrix of the cross product
  Matrix3d D;
  D << 0, -d.z(), d.y(), d.z(), 0, -d.x(), -d.y(), d.x(), 0;
  return I_cm - M * D * D;
//! wrong: minus
  return I_cm - M * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
//! wrong: the dyad with a plus sign
  return I_cm + M * (d.squaredNorm() * Matrix3d::Identity() + d * d.transpose());
//! wrong: Steiner's scalar theorem on all axes
  return I_cm + M * d.squaredNorm() * Matrix3d::Identity();
//! wrong: the mass is forgotten
  return I_cm + d.squaredNorm() * Matrix3d::Identity() - d * d.transpose();
//! wrong: length of d in place of its square
  return I_cm + M * (d.norm() * Matrix3d::Identity() - d * d.transpose());
//! wrong: inner product in place of the outer
  const Matrix3d J = d.dot(d) * Matrix3d::Identity() - d.transpose() * d;
  return I_cm + M * J;
//! wrong: only the moments, not the products
  Matrix3d I = I_cm;
  for (int i = 0; i < 3; ++i) I(i, i) += M * (d.squaredNorm() - d[i] * d[i]);
  return I;
//! wrong: the square added to every entry
-  for (int i = 0; i < 3; ++i) I(i, i) += M * (d.squaredNorm() - d[i] * d[i]);
+  I.array() += M * d.squaredNorm();
+  I -= M * d * d.transpose();
//! wrong: matrix of ones for the unit matrix
  return I_cm + M * (d.squaredNorm() * Matrix3d::Ones() - d * d.transpose());
