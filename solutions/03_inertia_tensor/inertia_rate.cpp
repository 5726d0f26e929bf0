#include "rigid/inertia_tensor.hpp"

namespace rigid {

Matrix3d inertia_rate(const Matrix3d& I, const Vector3d& omega) {
  // Each column of I rotates like a vector, and so does each row.
  Matrix3d one_index;
  for (int j = 0; j < 3; ++j) one_index.col(j) = omega.cross(I.col(j));
  return one_index + one_index.transpose();
}

}  // namespace rigid
