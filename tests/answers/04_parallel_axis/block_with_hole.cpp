#include <cmath>
#include <numbers>
#include <rigid/parallel_axis.hpp>
Matrix3d block_with_hole(double density, const Vector3d& edges, const Vector3d& center, double radius) {
//! wrong: three quarters for four thirds
  const double mb = density * edges.prod(), ms = 3.0 / 4 * std::numbers::pi * density * std::pow(radius, 3), m = mb - ms;
  Matrix3d C = Matrix3d(edges.cwiseAbs2().asDiagonal()) * mb / 12;
  C -= ms * (radius * radius / 5 * Matrix3d::Identity() + center * center.transpose());
  const Vector3d s = -ms * center;
  C -= s * s.transpose() / m;
  return C.trace() * Matrix3d::Identity() - C;
//! right: second moments, centred
  const double mb = density * edges.prod(), ms = 4 * std::numbers::pi / 3 * density * radius * radius * radius, m = mb - ms;
  Matrix3d C = Matrix3d(edges.cwiseAbs2().asDiagonal()) * mb / 12;
  C -= ms * (radius * radius / 5 * Matrix3d::Identity() + center * center.transpose());
  const Vector3d s = -ms * center;
  C -= s * s.transpose() / m;
  return C.trace() * Matrix3d::Identity() - C;
