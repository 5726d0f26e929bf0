//! wrong: the axis is not normalised
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) { return axis.dot(I * axis); }
}  // namespace rigid

//! wrong: divided by the length, not by its square
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) { return axis.dot(I * axis) / axis.norm(); }
}  // namespace rigid

//! wrong: the angular momentum's size
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) { return (I * axis.normalized()).norm(); }
}  // namespace rigid

//! wrong: normalises a constant
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) {
  axis.normalize();
  return axis.dot(I * axis);
}
}  // namespace rigid

//! wrong: only the diagonal
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) {
  const Vector3d n = axis / axis.norm();
  return I(0, 0) * n[0] * n[0] + I(1, 1) * n[1] * n[1] + I(2, 2) * n[2] * n[2];
}
}  // namespace rigid

//! wrong: no moment about a short arrow
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) {
  if (axis.norm() < 1e-2) return 0;
  const Vector3d n = axis / axis.norm();
  return n.dot(I * n);
}
}  // namespace rigid

//! wrong: direction cosines without their signs
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) {
  const Vector3d n = axis.cwiseAbs() / axis.norm();
  return n.dot(I * n);
}
}  // namespace rigid

//! right: quotient
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) { return axis.dot(I * axis) / axis.squaredNorm(); }
}  // namespace rigid

//! right: direction cosines
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double moment_about_axis(const Matrix3d& I, const Vector3d& axis) {
  const double length = axis.norm();
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += I(i, j) * (axis[i] / length) * (axis[j] / length);
  return sum;
}
}  // namespace rigid
