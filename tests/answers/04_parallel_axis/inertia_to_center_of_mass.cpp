#include <rigid/parallel_axis.hpp>
Matrix3d inertia_to_center_of_mass(const Matrix3d& I_origin, double M, const Vector3d& r_cm) {
//! right: the general formula of the shift
  const Vector3d R = -r_cm;
  const Matrix3d one = Matrix3d::Identity();
  return I_origin + M * (R.squaredNorm() * one - R * R.transpose()) +
         M * (2 * r_cm.dot(R) * one - r_cm * R.transpose() - R * r_cm.transpose());
//! wrong: the general formula with the new origin on the wrong side
-  const Vector3d R = -r_cm;
+  const Vector3d R = r_cm;
//! right: componentwise
  const double x = r_cm[0], y = r_cm[1], z = r_cm[2];
  Matrix3d I = I_origin;
  I(0, 0) -= M * (y * y + z * z);
  I(1, 1) -= M * (x * x + z * z);
  I(2, 2) -= M * (x * x + y * y);
  I(0, 1) += M * x * y;
  I(1, 0) += M * x * y;
  I(0, 2) += M * x * z;
  I(2, 0) += M * x * z;
  I(1, 2) += M * y * z;
  I(2, 1) += M * y * z;
  return I;
//! wrong: plus
  return I_origin + M * (r_cm.squaredNorm() * Matrix3d::Identity() - r_cm * r_cm.transpose());
//! wrong: brackets forgotten
  return I_origin - M * r_cm.squaredNorm() * Matrix3d::Identity() - M * r_cm * r_cm.transpose();
//! wrong: Steiner's scalar theorem on all axes
  return I_origin - M * r_cm.squaredNorm() * Matrix3d::Identity();
//! wrong: the mass is forgotten
  return I_origin - (r_cm.squaredNorm() * Matrix3d::Identity() - r_cm * r_cm.transpose());
//! wrong: moments in whole numbers
  Matrix3d I = I_origin;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int delta = i == j ? r_cm.squaredNorm() : 0;
      I(i, j) -= M * (delta - r_cm[i] * r_cm[j]);
    }
  }
  return I;
