#include "rigid/parallel_axis.hpp"

namespace rigid {

Matrix3d inertia_about_shifted_origin(const Matrix3d& I_origin, double M, const Vector3d& r_cm, const Vector3d& R) {
  const Matrix3d quadratic = R.squaredNorm() * Matrix3d::Identity() - R * R.transpose();
  const Matrix3d mixed = 2 * r_cm.dot(R) * Matrix3d::Identity() - r_cm * R.transpose() - R * r_cm.transpose();
  return I_origin + M * (quadratic + mixed);
}

}  // namespace rigid
