//! wrong: without one half
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) { return omega.dot(I * omega); }
}  // namespace rigid

//! wrong: one half in whole numbers
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) { return 1 / 2 * omega.dot(I * omega); }
}  // namespace rigid

//! wrong: only the diagonal
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) {
  double T = 0;
  for (int i = 0; i < 3; ++i) T += 0.5 * I(i, i) * omega[i] * omega[i];
  return T;
}
}  // namespace rigid

//! wrong: product of the lengths
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) { return 0.5 * (I * omega).norm() * omega.norm(); }
}  // namespace rigid

//! wrong: each product of inertia only once
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) {
  const double diagonal = I(0, 0) * omega[0] * omega[0] + I(1, 1) * omega[1] * omega[1] + I(2, 2) * omega[2] * omega[2];
  const double mixed = I(0, 1) * omega[0] * omega[1] + I(0, 2) * omega[0] * omega[2] + I(1, 2) * omega[1] * omega[2];
  return 0.5 * (diagonal + mixed);
}
}  // namespace rigid

//! wrong: the sum is never set
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) {
  double T;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) T += 0.5 * I(i, j) * omega[i] * omega[j];
  return T;
}
}  // namespace rigid

//! wrong: whole numbers
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) {
  int T = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) T += I(i, j) * omega[i] * omega[j];
  return T / 2.0;
}
}  // namespace rigid

//! wrong: small energies are taken for none
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) {
  const double T = 0.5 * omega.dot(I * omega);
  return T > 1e-9 ? T : 0;
}
}  // namespace rigid

//! right: written out
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) {
  const double diagonal = I(0, 0) * omega[0] * omega[0] + I(1, 1) * omega[1] * omega[1] + I(2, 2) * omega[2] * omega[2];
  const double mixed = I(0, 1) * omega[0] * omega[1] + I(0, 2) * omega[0] * omega[2] + I(1, 2) * omega[1] * omega[2];
  return diagonal / 2 + mixed;
}
}  // namespace rigid

//! right: a row times a column
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) {
  const Eigen::RowVector3d row = omega.transpose();
  return (row * I * omega).value() / 2;
}
}  // namespace rigid

//! right: on the principal axes
#include <rigid/inertia_tensor.hpp>
namespace rigid {
double kinetic_energy(const Matrix3d& I, const Vector3d& omega) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
  const Vector3d w = solver.eigenvectors().transpose() * omega;
  return 0.5 * solver.eigenvalues().dot(w.cwiseAbs2());
}
}  // namespace rigid
