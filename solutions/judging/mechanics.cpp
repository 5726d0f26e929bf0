#include "solutions/judging/mechanics.hpp"

#include <algorithm>
#include <cmath>

namespace workbook::judging {

Vector3d cross(const Vector3d& a, const Vector3d& b) { return a.cross(b); }

Matrix3d columns(const Vector3d& a, const Vector3d& b, const Vector3d& c) { return (Matrix3d() << a, b, c).finished(); }

Matrix3d skew(const Vector3d& w) { return Matrix3d{{0, -w[2], w[1]}, {w[2], 0, -w[0]}, {-w[1], w[0], 0}}; }

Vector3d axial(const Matrix3d& W) { return {W(2, 1), W(0, 2), W(1, 0)}; }

Vector3d axial_part(const Matrix3d& W) { return axial(W - W.transpose()) / 2; }

Vector3d in_xy_plane(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

Vector3d L_of(const Vector3d& I, const Vector3d& w) { return I.cwiseProduct(w); }

double twice_T(const Vector3d& I, const Vector3d& w) { return I.dot(w.cwiseAbs2()); }

Vector3d free_rate(const Vector3d& I, const Vector3d& w) { return cross(L_of(I, w), w).cwiseQuotient(I); }

VectorXd solution_of(const Eigen::MatrixXd& A, const VectorXd& b) { return A.fullPivLu().solve(b); }

Matrix3d dyad(const Vector3d& r) { return r * r.transpose(); }

Matrix3d turn(const Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.stableNormalized()).toRotationMatrix();
}

Matrix3d attitude(const Vector3d& angles) {
  return turn(z_axis, angles[0]) * turn(y_axis, angles[1]) * turn(z_axis, angles[2]);
}

Matrix3d diagonal_part(const Matrix3d& I) { return I.diagonal().asDiagonal(); }

Matrix3d products_flipped(const Matrix3d& I) { return 2 * diagonal_part(I) - I; }

Matrix3d of_unit_mass(const Vector3d& r) { return r.squaredNorm() * Matrix3d::Identity() - dyad(r); }

Matrix3d second_moment(const VectorXd& m, const Matrix3Xd& r) { return r * m.asDiagonal() * r.transpose(); }

Matrix3d tensor_of_moment(const Matrix3d& C) { return C.trace() * Matrix3d::Identity() - C; }

Matrix3d moment_of_tensor(const Matrix3d& I) { return I.trace() / 2 * Matrix3d::Identity() - I; }

Vector3d center_of_mass(const VectorXd& m, const Matrix3Xd& r) { return r * m / m.sum(); }

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
