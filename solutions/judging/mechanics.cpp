#include "solutions/judging/mechanics.hpp"

#include <algorithm>
#include <cmath>

namespace workbook::judging {

Matrix3d of_unit_mass_by_entries(const Vector3d& r) {
  const double x = r.x(), y = r.y(), z = r.z();
  return Matrix3d{{y * y + z * z, -x * y, -x * z}, {-x * y, x * x + z * z, -y * z}, {-x * z, -y * z, x * x + y * y}};
}

Matrix3Xd six_points(const Matrix3d& I_cm, double M) {
  const PrincipalFrame spread(moment_of_tensor(I_cm));
  const Matrix3d reach = spread.axes * (3 / M * spread.moments.cwiseMax(0)).cwiseSqrt().asDiagonal();
  return (Matrix3Xd(3, 6) << reach, -reach).finished();
}

Matrix3d of_cuboid(double M, const Vector3d& edges, double diagonal, double product) {
  Matrix3d I = product * M * dyad(edges);
  I.diagonal() = diagonal * M * (edges.squaredNorm() - edges.array().square());
  return I;
}

Matrix3Xd gauss_points_of_cuboid(const Vector3d& edges) {
  Matrix3Xd points(3, 8);
  for (int p = 0; p < 8; ++p)
    points.col(p) = Vector3d(p & 1 ? 1 : -1, p & 2 ? 1 : -1, p & 4 ? 1 : -1).cwiseProduct(edges) / std::sqrt(12.0);
  return points;
}

PrincipalFrame::PrincipalFrame(const Matrix3d& I) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
  moments = solver.eigenvalues();
  axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);  // a solver does not care for handedness
}

namespace legal {

namespace {

constexpr double rounding = 1e-9;

/// Holds for each 3×3 matrix of one or several.
template <class Predicate>
bool each(const Value& value, const Predicate& holds) {
  for (std::size_t k = 0; k + 9 <= value.numbers.size(); k += 9) {
    if (!holds(Matrix3d(Eigen::Map<const Matrix3d>(value.numbers.data() + k)))) return false;
  }
  return true;
}

}  // namespace

bool is_inertia_tensor(const Matrix3d& I) {
  return (I - I.transpose()).norm() <= rounding * I.norm() &&
         PrincipalFrame(moment_of_tensor(I)).moments[0] >= -rounding * I.norm();
}

bool positive(const Value& value) {
  return std::ranges::all_of(value.numbers, [](double number) { return number > 0; });
}

bool not_negative(const Value& value) {
  return std::ranges::all_of(value.numbers, [](double number) { return number >= 0; });
}

bool nonzero(const Value& value) {
  return std::ranges::any_of(value.numbers, [](double number) { return number != 0; });
}

bool ascending(const Value& value) { return positive(value) && std::ranges::is_sorted(value.numbers); }

bool inertia_tensors(const Value& value) { return each(value, is_inertia_tensor); }

bool regular_tensors(const Value& value) {
  return each(value, [](const Matrix3d& I) {
    return is_inertia_tensor(I) && PrincipalFrame(I).moments[0] > rounding * I.norm();
  });
}

bool rotation(const Value& value) {
  return each(value, [](const Matrix3d& R) {
    return (R.transpose() * R - Matrix3d::Identity()).norm() < rounding && R.determinant() > 0;
  });
}

bool latitude(const Value& value) { return std::abs(value.numbers[0]) <= pi / 2; }

bool off_gimbal_lock(const Value& value) { return std::abs(std::sin(value.numbers[1])) > 1e-6; }

}  // namespace legal

}  // namespace workbook::judging
