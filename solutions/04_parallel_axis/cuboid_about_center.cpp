#include "rigid/parallel_axis.hpp"

namespace rigid {

Matrix3d cuboid_about_center(double M, double a, double b, double c) {
  // Averages over the body: <x²> = a²/12 for x from −a/2 to a/2, and <xy> = 0 by symmetry.
  const Vector3d mean_squares = Vector3d(a, b, c).cwiseAbs2() / 12;
  const Vector3d moments = M * (mean_squares.sum() - mean_squares.array());
  return moments.asDiagonal();
}

}  // namespace rigid
