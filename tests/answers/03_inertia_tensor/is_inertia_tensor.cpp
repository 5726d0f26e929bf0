#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/inertia_tensor.hpp>
int is_inertia_tensor(const Matrix3d& I) {
//! right: symmetry and the triangle inequality of the eigenvalues
  const double big = I.cwiseAbs().maxCoeff();
  if ((I - I.transpose()).cwiseAbs().maxCoeff() > 1e-9 * big) return 0;
  Eigen::SelfAdjointEigenSolver<Matrix3d> s(I);
  const Vector3d m = s.eigenvalues();
  return m[0] + m[1] - m[2] >= -1e-9 * big;
//! wrong: strict inequality
-  return m[0] + m[1] - m[2] >= -1e-9 * big;
+  return m[0] + m[1] > m[2] * (1 + 1e-9);
//! wrong: answer inverted
-  if ((I - I.transpose()).cwiseAbs().maxCoeff() > 1e-9 * big) return 0;
+  if ((I - I.transpose()).cwiseAbs().maxCoeff() > 1e-9 * big) return 1;
@@
-  return m[0] + m[1] - m[2] >= -1e-9 * big;
+  return m[0] + m[1] - m[2] >= -1e-9 * big ? 0 : 1;
//! wrong: triangle inequality on the diagonal
  if (!I.isApprox(I.transpose(), 1e-9)) return 0;
  return I(0, 0) + I(1, 1) >= I(2, 2) && I(1, 1) + I(2, 2) >= I(0, 0) && I(0, 0) + I(2, 2) >= I(1, 1);
//! wrong: only positive definite
  if (!I.isApprox(I.transpose(), 1e-9)) return 0;
  Eigen::SelfAdjointEigenSolver<Matrix3d> s(I);
  return s.eigenvalues()[0] >= -1e-9 * I.cwiseAbs().maxCoeff();
//! wrong: symmetry not asked
  Eigen::SelfAdjointEigenSolver<Matrix3d> s(I);
  const Vector3d m = s.eigenvalues();
  return m[0] + m[1] - m[2] >= -1e-9 * I.cwiseAbs().maxCoeff();
