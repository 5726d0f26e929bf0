#include <cmath>
#include <rigid/parallel_axis.hpp>
Matrix3d cuboid_about_center(double M, double a, double b, double c) {
//! right: from half edges
  const double x = a / 2, y = b / 2, z = c / 2;
  Matrix3d I = Matrix3d::Zero();
  I(0, 0) = M * (y * y + z * z) / 3;
  I(1, 1) = M * (x * x + z * z) / 3;
  I(2, 2) = M * (x * x + y * y) / 3;
  return I;
//! right: eight point masses at the Gauss points, exact for squares
  Matrix3d I = Matrix3d::Zero();
  const double g = 0.5 / std::sqrt(3.0);
  for (double x : {-g, g})
    for (double y : {-g, g})
      for (double z : {-g, g}) {
        const Vector3d r(a * x, b * y, c * z);
        I += M / 8 * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
      }
  return I;
//! wrong: one third, as about the corner
  return M / 3 * Vector3d(b * b + c * c, a * a + c * c, a * a + b * b).asDiagonal().toDenseMatrix();
//! wrong: one twelfth in whole numbers
  Matrix3d I = Matrix3d::Zero();
  I(0, 0) = 1 / 12 * M * (b * b + c * c);
  I(1, 1) = 1 / 12 * M * (a * a + c * c);
  I(2, 2) = 1 / 12 * M * (a * a + b * b);
  return I;
//! wrong: the square of the same edge on the diagonal
  return M / 12 * Vector3d(a * a, b * b, c * c).asDiagonal().toDenseMatrix();
//! wrong: square of the sum
  return M / 12 * Vector3d(std::pow(b + c, 2), std::pow(a + c, 2), std::pow(a + b, 2)).asDiagonal().toDenseMatrix();
//! wrong: x and z exchanged
  Matrix3d I = Matrix3d::Zero();
  I.diagonal() << a * a + b * b, a * a + c * c, b * b + c * c;
  return I * M / 12;
//! wrong: products of inertia of the corner
  Matrix3d I;
  I << (b * b + c * c) / 12, -a * b / 4, -a * c / 4, -a * b / 4, (a * a + c * c) / 12, -b * c / 4, -a * c / 4,
      -b * c / 4, (a * a + b * b) / 12;
  return M * I;
//! wrong: off the diagonal nothing is ever set
  Matrix3d I;
  I(0, 0) = M * (b * b + c * c) / 12;
  I(1, 1) = M * (a * a + c * c) / 12;
  I(2, 2) = M * (a * a + b * b) / 12;
  return I;
//! wrong: a plate has no volume, so nothing is returned for it
  if (a * b * c == 0) return Matrix3d::Zero();
  return M / 12 * Vector3d(b * b + c * c, a * a + c * c, a * a + b * b).asDiagonal().toDenseMatrix();
