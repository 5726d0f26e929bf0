#include "rigid/parallel_axis.hpp"

#include <numbers>

namespace rigid {

namespace {

Matrix3d of_unit_mass_at(const Vector3d& r) { return r.squaredNorm() * Matrix3d::Identity() - r * r.transpose(); }

}  // namespace

Matrix3d block_with_hole(double density, const Vector3d& edges, const Vector3d& center, double radius) {
  const double block = density * edges.prod();
  const double ball = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
  const double rest = block - ball;
  const Vector3d center_of_mass = -ball / rest * center;

  const Vector3d squares = edges.cwiseAbs2();
  Matrix3d I = (block / 12 * (Vector3d::Constant(squares.sum()) - squares)).asDiagonal();
  I -= 0.4 * ball * radius * radius * Matrix3d::Identity() + ball * of_unit_mass_at(center);
  return I - rest * of_unit_mass_at(center_of_mass);
}

}  // namespace rigid
