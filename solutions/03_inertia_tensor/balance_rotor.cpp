#include "rigid/inertia_tensor.hpp"

namespace rigid {

Matrix3Xd balance_rotor(const VectorXd& m, const Matrix3Xd& r, const Vector2d& planes, double correction) {
  Matrix3Xd positions = Matrix3Xd::Zero(3, 2);
  positions.row(2) = planes.transpose();
  for (Eigen::Index p = 0; p < m.size(); ++p) {
    // Two masses in the planes that act on the bearings as this one does, like the supports of a beam.
    const double share = (r(2, p) - planes[0]) / (planes[1] - planes[0]);
    positions.topRows<2>().col(0) -= m[p] * (1 - share) / correction * r.col(p).head<2>();
    positions.topRows<2>().col(1) -= m[p] * share / correction * r.col(p).head<2>();
  }
  return positions;
}

}  // namespace rigid
