#include <rigid/inertia_tensor.hpp>
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) {
//! right: quotient
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) { return axis.dot(I * axis) / axis.squaredNorm(); }
//! right: direction cosines
  const double length = axis.norm();
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += I(i, j) * (axis[i] / length) * (axis[j] / length);
  return sum;
//! wrong: the axis is not normalised
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) { return axis.dot(I * axis); }
//! wrong: divided by the length, not by its square
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) { return axis.dot(I * axis) / axis.norm(); }
//! wrong: the angular momentum's size
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) { return (I * axis.normalized()).norm(); }
//! wrong: normalises a constant
  axis.normalize();
  return axis.dot(I * axis);
//! wrong: only the diagonal
  const Vector3d n = axis / axis.norm();
  return I(0, 0) * n[0] * n[0] + I(1, 1) * n[1] * n[1] + I(2, 2) * n[2] * n[2];
//! wrong: no moment about a short arrow
  if (axis.norm() < 1e-2) return 0;
  const Vector3d n = axis / axis.norm();
  return n.dot(I * n);
//! wrong: direction cosines without their signs
  const Vector3d n = axis.cwiseAbs() / axis.norm();
  return n.dot(I * n);
