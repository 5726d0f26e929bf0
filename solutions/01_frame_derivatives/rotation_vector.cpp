#include "rigid/frame_derivatives.hpp"

#include <cmath>

namespace rigid {

Vector3d rotation_vector(const Matrix3d& E) {
  // E − Eᵀ = 2 sin θ [n]× and tr E = 1 + 2 cos θ; of sine and cosine at least
  // one has all its digits.
  const Vector3d sine_axis = Vector3d(E(2, 1) - E(1, 2), E(0, 2) - E(2, 0), E(1, 0) - E(0, 1)) / 2;
  const double sine = sine_axis.norm(), cosine = (E.trace() - 1) / 2, angle = std::atan2(sine, cosine);
  if (cosine > 0) return sine > 0 ? Vector3d(angle / sine * sine_axis) : sine_axis;
  // Towards half a turn the sine vanishes, but not (E + Eᵀ)/2 − cos θ 1 = (1 −
  // cos θ) n nᵀ: its columns lie along n.
  const Matrix3d along = (E + E.transpose()) / 2 - cosine * Matrix3d::Identity();
  Eigen::Index longest = 0;
  along.diagonal().maxCoeff(&longest);
  const Vector3d axis = along.col(longest).normalized();
  return axis.dot(sine_axis) < 0 ? Vector3d(-angle * axis) : Vector3d(angle * axis);
}

}  // namespace rigid
