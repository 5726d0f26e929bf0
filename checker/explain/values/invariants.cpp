// What is right of a wrong result: a direction, a length, an axis, an angle, principal values.
#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace workbook {

namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

constexpr double invariant_exactness = 1e-7;
constexpr std::size_t fewest_invariant = 5;  // cases, or it may be an accident

/// What two results have in common: true, false, or nothing where the right result does not tell.
using Common = std::function<std::optional<bool>(const Value& yours, const Value& right)>;

struct Invariant {
  const char* name;
  const char* words;
  Common is_common;
};

bool is_near(double one, double other, double size) { return std::abs(one - other) <= invariant_exactness * size; }

std::optional<bool> is_parallel(const Vector3d& yours, const Vector3d& right) {
  if (yours.norm() == 0 || right.norm() == 0) return std::nullopt;
  return yours.normalized().cross(right.normalized()).norm() <= invariant_exactness;
}

/// Twice the sine of the angle times the axis.
Vector3d axis_of(const Matrix3d& R) { return {R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)}; }

bool is_rotation(const Matrix3d& R) {
  return (R.transpose() * R - Matrix3d::Identity()).norm() <= invariant_exactness && R.determinant() > 0;
}

std::vector<Invariant> of_vectors() {
  return {{"direction", "Your vector has the right direction at every case, and another length.",
           [](const Value& yours, const Value& right) -> std::optional<bool> {
             const Vector3d y = as_matrix(yours), e = as_matrix(right);
             const auto parallel = is_parallel(y, e);
             return parallel ? std::optional(*parallel && y.dot(e) > 0) : parallel;
           }},
          {"line", "Your vector lies along the right line at every case, but its length and sense are others.",
           [](const Value& yours, const Value& right) { return is_parallel(as_matrix(yours), as_matrix(right)); }},
          {"length", "Your vector has the right length at every case, and another direction.",
           [](const Value& yours, const Value& right) -> std::optional<bool> {
             const double length = as_matrix(right).norm();
             if (length == 0) return std::nullopt;
             return is_near(as_matrix(yours).norm(), length, length);
           }}};
}

std::vector<Invariant> of_rotations() {
  const auto with = [](auto compare) {
    return [compare](const Value& yours, const Value& right) -> std::optional<bool> {
      const Matrix3d y = as_matrix(yours), e = as_matrix(right);
      if (!is_rotation(e) || axis_of(e).norm() < 1e-2) return std::nullopt;
      return is_rotation(y) && compare(y, e);
    };
  };
  return {
      {"axis", "Your matrix turns about the right axis at every case, but not by the right angle.",
       with([](const Matrix3d& y, const Matrix3d& e) { return is_parallel(axis_of(y), axis_of(e)).value_or(true); })},
      {"angle", "Your matrix turns by the right angle at every case, but not about the right axis.",
       with([](const Matrix3d& y, const Matrix3d& e) { return is_near(y.trace(), e.trace(), 1); })}};
}

std::vector<Invariant> of_tensors() {
  const auto with = [](auto compare) {
    return [compare](const Value& yours, const Value& right) -> std::optional<bool> {
      const Matrix3d y = as_matrix(yours), e = as_matrix(right);
      const double size = e.norm();
      const bool is_tensor = (e - e.transpose()).norm() <= invariant_exactness * size;
      if (!is_tensor || Matrix3d(e - e.trace() / 3 * Matrix3d::Identity()).norm() < 1e-2 * size) return std::nullopt;
      return (y - y.transpose()).norm() <= invariant_exactness * size && compare(y, e, size);
    };
  };
  return {{"principal_values", "Your matrix has the right principal values at every case, but along other axes.",
           with([](const Matrix3d& y, const Matrix3d& e, double size) {
             const auto moments = [](const Matrix3d& m) {
               return Eigen::SelfAdjointEigenSolver<Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues();
             };
             return (moments(y) - moments(e)).norm() <= invariant_exactness * size;
           })},
          {"principal_axes", "Your matrix has the right principal axes at every case, but other principal values.",
           with([](const Matrix3d& y, const Matrix3d& e, double size) {
             return (y * e - e * y).norm() <= invariant_exactness * size * y.norm();
           })}};
}

/// Which of the three angles are right by themselves.
std::optional<Reason> diagnose_angles(const ExerciseReference& exercise, const Answers& answers) {
  const char* const names[] = {"phi", "theta", "psi"};
  std::vector<std::string> right, wrong;
  for (std::size_t n = 0; n < 3; ++n) {
    const bool is_right = std::ranges::all_of(deciding_cases(exercise), [&](std::size_t i) {
      const double more = answers[i]->numbers[n] - exercise.cases[i].expected.numbers[n];
      return std::abs(std::remainder(more, 2 * std::numbers::pi)) <= invariant_exactness;
    });
    (is_right ? right : wrong).emplace_back(names[n]);
  }
  if (right.empty() || wrong.empty()) return std::nullopt;
  return Reason{ReasonKind::place, "angles",
                fmt::format("At every case {} {} right, and {} {} not.", listed(right),
                            right.size() == 1 ? "is" : "are", listed(wrong), wrong.size() == 1 ? "is" : "are"),
                Weight::symptom};
}

}  // namespace

std::optional<Reason> diagnose_invariant(const ExerciseReference& exercise, const Answers& answers) {
  if (!all_deciding_cases_answered(exercise, answers)) return std::nullopt;
  const std::vector<std::size_t> deciding = deciding_cases(exercise);
  if (!std::ranges::all_of(deciding, [&](std::size_t i) { return answers[i]->is_finite(); })) return std::nullopt;
  if (exercise.comparison == Comparison::attitude_by_angles) return diagnose_angles(exercise, answers);
  std::vector<Invariant> invariants;
  if (exercise.result_kind == Kind::vector3 &&
      (exercise.comparison == Comparison::plain || exercise.comparison == Comparison::rotation_by_vector))
    invariants = of_vectors();
  if (exercise.result_kind == Kind::matrix3 && exercise.comparison == Comparison::plain) {
    invariants = of_rotations();
    std::ranges::move(of_tensors(), std::back_inserter(invariants));
  }
  // Three numbers of different units are no vector, and results along one line have one direction anyway.
  if (exercise.result_units.size() > 1) return std::nullopt;
  for (const Invariant& each : invariants) {
    std::size_t common = 0, wrong = 0;
    const bool holds = std::ranges::all_of(deciding, [&](std::size_t i) {
      // Half a turn has two rotation vectors.
      const std::optional<bool> is_common = each.is_common(*answers[i], nearest_expected(exercise, i, *answers[i]));
      common += is_common && *is_common ? 1 : 0;
      wrong += is_common && *is_common && !passes(exercise, i, *answers[i]) ? 1 : 0;
      return is_common.value_or(true);
    });
    const bool is_trivial = exercise.result_kind == Kind::vector3 && std::ranges::all_of(deciding, [&](std::size_t i) {
                              const Vector3d e = as_matrix(exercise.cases[i].expected);
                              return (e.array() != 0).count() <= 1;
                            });
    if (holds && !is_trivial && common >= fewest_invariant && 2 * wrong >= common)
      return Reason{ReasonKind::place, each.name, each.words, Weight::symptom};
  }
  return std::nullopt;
}

}  // namespace workbook
