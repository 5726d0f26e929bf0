#include "rigid/inertia_tensor.hpp"

namespace rigid {

Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r) {
  Matrix3d I = Matrix3d::Zero();
  for (int p = 0; p < m.size(); ++p) {
    const Vector3d r_p = r.col(p);
    I += m[p] * (r_p.squaredNorm() * Matrix3d::Identity() - r_p * r_p.transpose());
  }
  return I;
}

}  // namespace rigid
