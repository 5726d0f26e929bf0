#include <rigid/inertia_tensor.hpp>
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) {
//! right: written out
  const double diagonal = I(0, 0) * omega[0] * omega[0] + I(1, 1) * omega[1] * omega[1] + I(2, 2) * omega[2] * omega[2];
  const double mixed = I(0, 1) * omega[0] * omega[1] + I(0, 2) * omega[0] * omega[2] + I(1, 2) * omega[1] * omega[2];
  return diagonal / 2 + mixed;
//! wrong: each product of inertia only once
-  return diagonal / 2 + mixed;
+  return 0.5 * (diagonal + mixed);
//! right: a row times a column
  const Eigen::RowVector3d row = omega.transpose();
  return (row * I * omega).value() / 2;
//! right: on the principal axes
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
  const Vector3d w = solver.eigenvectors().transpose() * omega;
  return 0.5 * solver.eigenvalues().dot(w.cwiseAbs2());
//! wrong: without one half
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) { return omega.dot(I * omega); }
//! wrong: one half in whole numbers
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) { return 1 / 2 * omega.dot(I * omega); }
//! wrong: only the diagonal
  double T = 0;
  for (int i = 0; i < 3; ++i) T += 0.5 * I(i, i) * omega[i] * omega[i];
  return T;
//! wrong: product of the lengths
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) { return 0.5 * (I * omega).norm() * omega.norm(); }
//! wrong: the sum is never set
  double T;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) T += 0.5 * I(i, j) * omega[i] * omega[j];
  return T;
//! wrong: whole numbers
  int T = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) T += I(i, j) * omega[i] * omega[j];
  return T / 2.0;
//! wrong: small energies are taken for none
  const double T = 0.5 * omega.dot(I * omega);
  return T > 1e-9 ? T : 0;
//! wrong: a half that is computed in whole numbers with names
  auto ratio = [](int a, int b) { return a / b; };
  return ratio(1, 2) * omega.dot(I * omega);
