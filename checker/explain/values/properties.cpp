#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace workbook {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;

constexpr int shown_digits = 6;

/// Keeps the worst.
template <class Detail>
void consider(Violation& worst, double size, const Detail& detail) {
  if (size > worst.size) worst = {size, detail()};
}

/// matrix = sign × its transpose
Violation transposition_violation(const MatrixXd& matrix, double sign, double scale) {
  Violation worst;
  for (Index row = 0; row < matrix.rows(); ++row) {
    for (Index col = row; col < matrix.cols(); ++col) {
      const double entry = matrix(row, col), mirrored = matrix(col, row);
      consider(worst, std::abs(entry - sign * mirrored) / scale, [&] {
        const auto [first, second] = distinct_texts(entry, mirrored, shown_digits);
        return row == col ? fmt::format("entry ({0},{0}) is {1}", row, number_text(entry, shown_digits))
                          : fmt::format("entry ({0},{1}) is {2}, entry ({1},{0}) is {3}", row, col, first, second);
      });
    }
  }
  return worst;
}

Violation negative_eigenvalue(const Matrix3d& matrix, double scale) {
  Violation worst;
  if (transposition_violation(matrix, 1, scale).size > 1e-9) return worst;  // its eigenvalues are others
  const double smallest = Eigen::SelfAdjointEigenSolver<Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
  consider(worst, -smallest / scale,
           [&] { return "its smallest eigenvalue is " + number_text(smallest, shown_digits); });
  return worst;
}

Violation rotation_violation(const Matrix3d& matrix) {
  const Matrix3d products = matrix.transpose() * matrix;
  Violation worst;
  for (Index i = 0; i < products.rows(); ++i) {
    for (Index j = i; j < products.cols(); ++j) {
      consider(worst, std::abs(products(i, j) - (i == j ? 1 : 0)), [&] {
        return i == j ? fmt::format("column {} has the length {}", i,
                                    distinct_texts(std::sqrt(products(i, i)), 1, shown_digits).first)
                      : fmt::format("columns {} and {} have the dot product {}", i, j,
                                    number_text(products(i, j), shown_digits));
      });
    }
  }
  const double determinant = matrix.determinant();
  // With orthonormal columns the determinant can only be off by its sign.
  if (determinant < 0)
    consider(worst, 1 - determinant, [&] { return "its determinant is " + number_text(determinant, shown_digits); });
  return worst;
}

Violation length_violation(const Value& value) {
  const double length = as_matrix(value).norm();
  Violation worst;
  consider(worst, std::abs(length - 1),
           [&] { return "its length is " + distinct_texts(length, 1, shown_digits).first; });
  return worst;
}

Violation descent(const Value& value, double scale) {
  Violation worst;
  for (std::size_t n = 1; n < value.numbers.size(); ++n) {
    const double before = value.numbers[n - 1], here = value.numbers[n];
    consider(worst, (before - here) / scale, [&] {
      const auto [first, second] = distinct_texts(before, here, shown_digits);
      return fmt::format("component [{}] is {}, component [{}] is {}", n - 1, first, n, second);
    });
  }
  return worst;
}

Violation negative_entry(const Value& value, Kind kind, const Case& one) {
  Violation worst;
  for (std::size_t n = 0; n < value.numbers.size(); ++n) {
    consider(worst, -value.numbers[n] / scale_at(one, n), [&] {
      return fmt::format("{} is {}", entry_name(value, kind, n), number_text(value.numbers[n], shown_digits));
    });
  }
  return worst;
}

Violation oblique_angle(const Value& value, const Value& argument, const std::string& argument_name, double scale) {
  const double length = as_matrix(argument).norm();
  if (length == 0) return {};
  const double product = as_matrix(value).cwiseProduct(as_matrix(argument)).sum();
  Violation worst;
  consider(worst, std::abs(product) / (length * scale), [&] {
    return fmt::format("its dot product with {} is {}", argument_name, number_text(product, shown_digits));
  });
  return worst;
}

Violation drift_violation(const ExerciseReference& exercise, const Property& property, std::size_t case_index,
                          const Value& value) {
  if (value.cols == 0) return {};
  const Case& one = exercise.cases[case_index];
  const Deviation deviation = invariant_deviation(exercise, property, case_index, value);
  const std::vector<double>& weights = property.weights.at(case_index);
  const double constant = weighted_squares(weights, one.expected).front();
  Violation worst;
  for (std::size_t col = 0; col < deviation.allowed.size(); ++col) {
    const double difference = deviation.difference.numbers[col];
    consider(worst, std::abs(difference) / deviation.allowed[col] * one.tolerance, [&] {
      const auto [yours, right] = distinct_texts(constant + difference, constant, shown_digits);
      const std::string place = value.cols > 1 ? fmt::format("in column {} ", col) : "";
      return fmt::format("{}it is {} instead of {}", place, yours, right);
    });
  }
  return worst;
}

}  // namespace

Violation violation(const ExerciseReference& exercise, const Property& property, std::size_t case_index,
                    const Value& value) {
  const Case& one = exercise.cases.at(case_index);
  const double scale = *std::ranges::max_element(one.scale);
  switch (property.kind) {
    case PropertyKind::symmetric:
      return transposition_violation(as_matrix(value), 1, scale);
    case PropertyKind::antisymmetric:
      return transposition_violation(as_matrix(value), -1, scale);
    case PropertyKind::positive_semidefinite:
      return negative_eigenvalue(as_matrix(value), scale);
    case PropertyKind::rotation_matrix:
      return rotation_violation(as_matrix(value));
    case PropertyKind::unit_norm:
      return length_violation(value);
    case PropertyKind::ascending:
      return descent(value, scale);
    case PropertyKind::nonnegative:
      return negative_entry(value, exercise.result_kind, one);
    case PropertyKind::orthogonal_to_argument: {
      const auto argument = static_cast<std::size_t>(property.argument);
      return oblique_angle(value, one.inputs.at(argument), exercise.arguments.at(argument).name, scale);
    }
    case PropertyKind::constant_weighted_square:
      return drift_violation(exercise, property, case_index, value);
  }
  return {};
}

bool clearly_lacks(const ExerciseReference& exercise, const Property& property, std::size_t case_index,
                   const Value& value) {
  return violation(exercise, property, case_index, value).size > clear_margin * exercise.cases.at(case_index).tolerance;
}

std::vector<Reason> diagnose_properties(const ExerciseReference& exercise, const Answers& answers) {
  std::vector<Reason> diagnoses;
  for (const Property& property : exercise.properties) {
    bool all_expected_have_it = true;
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      if (clearly_lacks(exercise, property, i, exercise.cases[i].expected)) all_expected_have_it = false;
    }
    if (!all_expected_have_it) continue;

    for (std::size_t i : deciding_cases(exercise)) {
      if (i >= answers.size() || !answers[i] || !answers[i]->is_finite()) continue;
      if (!clearly_lacks(exercise, property, i, *answers[i])) continue;
      const std::string detail = violation(exercise, property, i, *answers[i]).detail;
      diagnoses.push_back(
          {ReasonKind::property, to_string(property.kind),
           fmt::format("{}; with yours, {} (case “{}”).", capitalized(without_full_stop(property.message)), detail,
                       exercise.cases[i].name),
           // A wrong order is all that there is to say.
           property.kind == PropertyKind::ascending ? Weight::cause : Weight::symptom, property.notes});
      break;
    }
  }
  return diagnoses;
}

}  // namespace workbook
