#include "rigid/measured.hpp"

namespace rigid {

Matrix3d attitude_from_rates(const VectorXd& t, const Matrix3Xd& omega) {
  Matrix3d A = Matrix3d::Identity();
  for (Eigen::Index k = 1; k < t.size(); ++k) {
    const Vector3d turn = (t[k] - t[k - 1]) / 2 * (omega.col(k - 1) + omega.col(k));
    // A rotation about an axis of the body stands on the right: it acts before all that was there.
    A *= Eigen::AngleAxisd(turn.stableNorm(), turn.stableNormalized()).toRotationMatrix();
  }
  return A;
}

}  // namespace rigid
