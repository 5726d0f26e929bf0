#include "rigid/inertia_tensor.hpp"

namespace rigid {

Matrix3d cuboid_about_corner(double M, double a, double b, double c) {
  // Averages over the body: <x²> = a²/3 and <xy> = ab/4, because x and y fill their ranges independently.
  const Vector3d edges(a, b, c);
  const Vector3d mean_squares = edges.cwiseAbs2() / 3;
  Matrix3d I = -M / 4 * edges * edges.transpose();
  I.diagonal() = M * (mean_squares.sum() - mean_squares.array());
  return I;
}

}  // namespace rigid
