#include <cmath>
#include <rigid/inertia_tensor.hpp>
Matrix3d cuboid_about_corner(double M, double a, double b, double c) {
//! right: from the centre, by the parallel-axis theorem
  const Vector3d d(a / 2, b / 2, c / 2);
  Matrix3d I = M * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
  I(0, 0) += M / 12 * (b * b + c * c);
  I(1, 1) += M / 12 * (a * a + c * c);
  I(2, 2) += M / 12 * (a * a + b * b);
  return I;
//! right: eight point masses at the Gauss points, exact for squares
  Matrix3d I = Matrix3d::Zero();
  const double g = 0.5 / std::sqrt(3.0);
  for (double x : {0.5 - g, 0.5 + g})
    for (double y : {0.5 - g, 0.5 + g})
      for (double z : {0.5 - g, 0.5 + g}) {
        const Vector3d r(a * x, b * y, c * z);
        I += M / 8 * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
      }
  return I;
//! wrong: about the centre
  return M / 12 * Vector3d(b * b + c * c, a * a + c * c, a * a + b * b).asDiagonal().toDenseMatrix();
//! wrong: products of inertia without the minus sign
  Matrix3d I;
  I << (b * b + c * c) / 3, a * b / 4, a * c / 4, a * b / 4, (a * a + c * c) / 3, b * c / 4, a * c / 4, b * c / 4,
      (a * a + b * b) / 3;
  return M * I;
//! wrong: one third and one quarter in whole numbers
  Matrix3d I;
  I << 1 / 3 * (b * b + c * c), -1 / 4 * a * b, -1 / 4 * a * c, -1 / 4 * a * b, 1 / 3 * (a * a + c * c), -1 / 4 * b * c,
      -1 / 4 * a * c, -1 / 4 * b * c, 1 / 3 * (a * a + b * b);
  return M * I;
//! wrong: the square of the same edge on the diagonal
  Matrix3d I = -M / 4 * Vector3d(a, b, c) * Vector3d(a, b, c).transpose();
  I(0, 0) = M * a * a / 3;
  I(1, 1) = M * b * b / 3;
  I(2, 2) = M * c * c / 3;
  return I;
//! wrong: one third everywhere
  Matrix3d I;
  I << b * b + c * c, -a * b, -a * c, -a * b, a * a + c * c, -b * c, -a * c, -b * c, a * a + b * b;
  return M / 3 * I;
//! wrong: the lower triangle is never set
  Matrix3d I;
  I(0, 0) = M / 3 * (b * b + c * c);
  I(1, 1) = M / 3 * (a * a + c * c);
  I(2, 2) = M / 3 * (a * a + b * b);
  I(0, 1) = -M / 4 * a * b;
  I(0, 2) = -M / 4 * a * c;
  I(1, 2) = -M / 4 * b * c;
  return I;
//! wrong: a plate has no volume, so nothing is returned for it
  const double volume = a * b * c;
  if (volume == 0) return Matrix3d::Zero();
  const double density = M / volume;
  Matrix3d I;
  I << (b * b + c * c) / 3, -a * b / 4, -a * c / 4, -a * b / 4, (a * a + c * c) / 3, -b * c / 4, -a * c / 4, -b * c / 4,
      (a * a + b * b) / 3;
  return density * volume * I;
//! wrong: density in place of the mass, so a plate divides by zero
  const double density = M / (a * b * c);
  Matrix3d I;
  I(0, 0) = density * a * b * c * (b * b + c * c) / 3;
  I(1, 1) = density * a * b * c * (a * a + c * c) / 3;
  I(2, 2) = density * a * b * c * (a * a + b * b) / 3;
  I(0, 1) = I(1, 0) = -density * a * a * b * b * c / 4;
  I(0, 2) = I(2, 0) = -density * a * a * b * c * c / 4;
  I(1, 2) = I(2, 1) = -density * a * b * b * c * c / 4;
  return I;
//! wrong: a twelfth on the diagonal, and one product copied
  Matrix3d I;
  I << (b * b + c * c) / 12, -a * b / 4, -a * c / 4, -a * b / 4, (a * a + c * c) / 12, -a * c / 4, -a * c / 4, -a * c / 4,
      (a * a + b * b) / 12;
  return M * I;
