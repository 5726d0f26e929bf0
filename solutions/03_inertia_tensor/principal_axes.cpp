#include "rigid/inertia_tensor.hpp"

namespace rigid {

Matrix3d principal_axes(const Matrix3d& I) {
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(I).eigenvectors();
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);  // a solver does not care for handedness, a triad does
  return axes;
}

}  // namespace rigid
