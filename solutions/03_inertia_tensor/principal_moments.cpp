#include "rigid/inertia_tensor.hpp"

namespace rigid {

Vector3d principal_moments(const Matrix3d& I) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(I, Eigen::EigenvaluesOnly).eigenvalues();  // already ascending
}

}  // namespace rigid
