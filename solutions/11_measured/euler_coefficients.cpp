#include "rigid/measured.hpp"

namespace rigid {

Vector3d euler_coefficients(const VectorXd& t, const Matrix3Xd& omega) {
  Vector3d slopes;
  for (int axis = 0; axis < 3; ++axis) {
    const VectorXd rate = omega.row((axis + 1) % 3).cwiseProduct(omega.row((axis + 2) % 3)).transpose();
    VectorXd sum = VectorXd::Zero(t.size());
    for (Eigen::Index k = 1; k < t.size(); ++k) sum[k] = sum[k - 1] + (t[k] - t[k - 1]) / 2 * (rate[k - 1] + rate[k]);
    // With the mean subtracted the line passes through the origin.
    sum.array() -= sum.mean();
    slopes[axis] = omega.row(axis).dot(sum) / sum.squaredNorm();
  }
  return slopes;
}

}  // namespace rigid
