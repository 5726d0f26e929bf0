#include <cmath>
#include <numbers>
#include <rigid/parallel_axis.hpp>
Matrix3d block_with_hole(double density, const Vector3d& edges, const Vector3d& center, double radius) {
//! right: second moments, centred
  const double mb = density * edges.prod(), ms = 4 * std::numbers::pi / 3 * density * radius * radius * radius, m = mb - ms;
  Matrix3d C = Matrix3d(edges.cwiseAbs2().asDiagonal()) * mb / 12;
  C -= ms * (radius * radius / 5 * Matrix3d::Identity() + center * center.transpose());
  const Vector3d s = -ms * center;
  C -= s * s.transpose() / m;
  return C.trace() * Matrix3d::Identity() - C;
//! wrong: three quarters for four thirds
-  const double mb = density * edges.prod(), ms = 4 * std::numbers::pi / 3 * density * radius * radius * radius, m = mb - ms;
+  const double mb = density * edges.prod(), ms = 3.0 / 4 * std::numbers::pi * density * std::pow(radius, 3), m = mb - ms;
//! wrong: the moment of a shell, and no change of origin
  const double M = density * edges.prod(), m = density * 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
  const Vector3d q = edges.cwiseAbs2();
  Matrix3d I = (M / 12 * (q.sum() - q.array())).matrix().asDiagonal();
  I -= 2.0 / 3 * m * radius * radius * Matrix3d::Identity();
  I -= m * (center.squaredNorm() * Matrix3d::Identity() - center * center.transpose());
  return I;
//! wrong: the mass of the whole block in the change of origin
  const double M = density * edges[0] * edges[1] * edges[2];
  const double m = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
  const auto dyad = [](const Vector3d& d) -> Matrix3d { return d.squaredNorm() * Matrix3d::Identity() - d * d.transpose(); };
  const double x = edges[0] * edges[0], y = edges[1] * edges[1], z = edges[2] * edges[2];
  Matrix3d I = Vector3d(y + z, x + z, x + y).asDiagonal();
  I *= M / 12;
  const Vector3d cm = -m * center / (M - m);
  return I - 0.4 * m * radius * radius * Matrix3d::Identity() - m * dyad(center) - M * dyad(cm);
