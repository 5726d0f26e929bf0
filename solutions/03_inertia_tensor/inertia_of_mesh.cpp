#include "rigid/inertia_tensor.hpp"

namespace rigid {

Matrix3d inertia_of_mesh(const Matrix3Xd& corners, double density) {
  // Each triangle spans a tetrahedron with the origin. Its volume is negative where the triangle is seen from outside.
  Matrix3d second_moment = Matrix3d::Zero();
  for (Eigen::Index k = 0; k + 2 < corners.cols(); k += 3) {
    const Matrix3d triangle = corners.middleCols<3>(k);
    const Vector3d sum = triangle.rowwise().sum();
    const double mass = density * triangle.determinant() / 6;
    second_moment += mass / 20 * (triangle * triangle.transpose() + sum * sum.transpose());
  }
  return second_moment.trace() * Matrix3d::Identity() - second_moment;
}

}  // namespace rigid
