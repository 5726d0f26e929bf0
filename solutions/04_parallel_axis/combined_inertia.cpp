#include "rigid/parallel_axis.hpp"

namespace rigid {

Matrix3d combined_inertia(const VectorXd& masses, const Matrix3Xd& centers, const std::vector<Matrix3d>& tensors) {
  const Vector3d center = centers * masses / masses.sum();
  Matrix3d I = Matrix3d::Zero();
  for (std::size_t k = 0; k < tensors.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const Vector3d d = centers.col(column) - center;
    I += tensors[k] + masses[column] * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
  }
  return I;
}

}  // namespace rigid
