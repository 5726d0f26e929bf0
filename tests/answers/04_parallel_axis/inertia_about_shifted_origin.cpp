#include <rigid/parallel_axis.hpp>
Matrix3d inertia_about_shifted_origin(const Matrix3d& I_origin, double M, const Vector3d& r_cm, const Vector3d& R) {
//! right: over the centre of mass
  const auto point = [M](const Vector3d& d) -> Matrix3d {
    return M * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
  };
  const Vector3d after = r_cm + R;
  return I_origin - point(r_cm) + point(after);
//! right: componentwise
  Matrix3d I = I_origin;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      I(i, j) -= M * (R[i] * R[j] + r_cm[i] * R[j] + R[i] * r_cm[j]);
      if (i == j) I(i, j) += M * (R.dot(R) + 2 * r_cm.dot(R));
    }
  }
  return I;
//! wrong: the new origin taken at R
  const Matrix3d one = Matrix3d::Identity();
  return I_origin + M * (R.squaredNorm() * one - R * R.transpose()) -
         M * (2 * r_cm.dot(R) * one - r_cm * R.transpose() - R * r_cm.transpose());
//! wrong: as if the old origin were the centre of mass
  return I_origin + M * (R.dot(R) * Matrix3d::Identity() - R * R.transpose());
//! wrong: only one of the two mixed products
  const Matrix3d one = Matrix3d::Identity();
  return I_origin + M * (R.squaredNorm() * one - R * R.transpose()) +
         M * (2 * r_cm.dot(R) * one - 2 * r_cm * R.transpose());
//! wrong: without the factor 2
-         M * (2 * r_cm.dot(R) * one - 2 * r_cm * R.transpose());
+         M * (r_cm.dot(R) * one - r_cm * R.transpose() - R * r_cm.transpose());
//! wrong: only the mixed terms
  const Matrix3d mixed = 2 * r_cm.dot(R) * Matrix3d::Identity() - r_cm * R.transpose() - R * r_cm.transpose();
  return I_origin + M * mixed;
//! wrong: centre of mass and shift exchanged in the list
Matrix3d inertia_about_shifted_origin(const Matrix3d& I_origin, double M, const Vector3d& R, const Vector3d& r_cm) {
  const Matrix3d one = Matrix3d::Identity();
  return I_origin + M * (R.squaredNorm() * one - R * R.transpose()) +
         M * (2 * r_cm.dot(R) * one - r_cm * R.transpose() - R * r_cm.transpose());
}
//! wrong: from the centre of mass to the new origin only
  const Vector3d d = r_cm + R;
  return I_origin + M * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
//! wrong: nothing changes if the old origin is the centre of mass
  if (r_cm.isZero()) return I_origin;
  const Vector3d d = r_cm + R;
  const Matrix3d one = Matrix3d::Identity();
  return I_origin - M * (r_cm.squaredNorm() * one - r_cm * r_cm.transpose()) +
         M * (d.squaredNorm() * one - d * d.transpose());
