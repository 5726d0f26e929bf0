#include "rigid/inertia_tensor.hpp"

namespace rigid {

int is_inertia_tensor(const Matrix3d& I) {
  const double rounding = 1e-9 * I.cwiseAbs().maxCoeff();
  if ((I - I.transpose()).cwiseAbs().maxCoeff() > rounding) return 0;
  // In ascending order; of the three triangle inequalities the one for the largest implies the others.
  const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(I, Eigen::EigenvaluesOnly).eigenvalues();
  return moments[0] + moments[1] - moments[2] >= -rounding ? 1 : 0;
}

}  // namespace rigid
