#include "rigid/frame_derivatives.hpp"

namespace rigid {

Vector3d angular_velocity_from_three_points(const Matrix3d& r, const Matrix3d& v) {
  // Seen from their mean point the three points have no translation, v = ω × x, and Σ x × v = Σ (x² 1 − x x) ω. Each of
  // the three loses what is along x; the sum loses nothing unless all x are parallel.
  const Matrix3d x = r.colwise() - r.rowwise().mean(), x_rate = v.colwise() - v.rowwise().mean();
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) sum += x.col(i).cross(x_rate.col(i));
  const Matrix3d tensor = x.squaredNorm() * Matrix3d::Identity() - x * x.transpose();
  return tensor.ldlt().solve(sum);
}

}  // namespace rigid
