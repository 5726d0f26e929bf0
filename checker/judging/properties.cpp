#include "checker/judging/properties.hpp"

#include "checker/judging/comparison.hpp"
#include "checker/judging/value_text.hpp"
#include "checker/messages/broken_properties.hpp"
#include "checker/messages/judging.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace workbook {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double clear_margin = 10.0;  // times the tolerance
constexpr int digits = 6;

/// Keeps the worst violation seen.
class Worst {
 public:
  template <class Detail>
  void consider(double size, Detail&& detail) {
    if (size > worst_.size) worst_ = {size, detail()};
  }
  Violation take() { return std::move(worst_); }

 private:
  Violation worst_;
};

/// Rows and columns as people count them.
std::size_t from_one(Index index) { return static_cast<std::size_t>(index) + 1; }

std::string entry_and_entry(Index row, Index col, double one, Index other_row, Index other_col, double other) {
  const auto [first, second] = distinct_texts(one, other, digits);
  return messages::two_entries_are(from_one(row), from_one(col), first, from_one(other_row), from_one(other_col),
                                   second);
}

/// matrix = sign × its transpose
Violation transposition_violation(const MatrixXd& matrix, double sign, double scale) {
  Worst worst;
  for (Index row = 0; row < matrix.rows(); ++row) {
    for (Index col = row; col < matrix.cols(); ++col) {
      const double entry = matrix(row, col), mirrored = matrix(col, row);
      worst.consider(std::abs(entry - sign * mirrored) / scale, [&] {
        return row == col ? messages::entry_is(from_one(row), from_one(row), number_text(entry, digits))
                          : entry_and_entry(row, col, entry, col, row, mirrored);
      });
    }
  }
  return worst.take();
}

Violation negative_eigenvalue(const MatrixXd& matrix, double scale) {
  const MatrixXd symmetric_part = (matrix + matrix.transpose()) / 2;
  const double smallest =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(symmetric_part, Eigen::EigenvaluesOnly).eigenvalues()[0];
  Worst worst;
  worst.consider(-smallest / scale, [&] { return messages::smallest_eigenvalue_is(number_text(smallest, digits)); });
  return worst.take();
}

Violation rotation_violation(const MatrixXd& matrix) {
  const MatrixXd products = matrix.transpose() * matrix;
  Worst worst;
  for (Index i = 0; i < products.rows(); ++i) {
    for (Index j = i; j < products.cols(); ++j) {
      worst.consider(std::abs(products(i, j) - (i == j ? 1 : 0)), [&] {
        return i == j ? messages::column_has_length(from_one(i),
                                                    distinct_texts(std::sqrt(products(i, i)), 1, digits).first)
                      : messages::columns_have_product(from_one(i), from_one(j), number_text(products(i, j), digits));
      });
    }
  }
  const double determinant = matrix.determinant();
  // With orthonormal columns the determinant can only be off by its sign.
  if (determinant < 0)
    worst.consider(1 - determinant, [&] { return messages::determinant_is(number_text(determinant, digits)); });
  return worst.take();
}

Violation length_violation(const Value& value) {
  const double length = as_matrix(value).norm();
  Worst worst;
  worst.consider(std::abs(length - 1), [&] { return messages::length_is(distinct_texts(length, 1, digits).first); });
  return worst.take();
}

Violation descent(const Value& value, double scale) {
  Worst worst;
  for (std::size_t n = 1; n < value.numbers.size(); ++n) {
    const double before = value.numbers[n - 1], here = value.numbers[n];
    worst.consider((before - here) / scale, [&] {
      const auto [first, second] = distinct_texts(before, here, digits);
      return messages::two_components_are(n, first, n + 1, second);
    });
  }
  return worst.take();
}

Violation negative_entry(const Value& value, Kind kind, const Case& one) {
  Worst worst;
  for (std::size_t n = 0; n < value.numbers.size(); ++n) {
    worst.consider(-value.numbers[n] / scale_at(one, n), [&] {
      return messages::part_is(entry_name(value, kind, n), number_text(value.numbers[n], digits));
    });
  }
  return worst.take();
}

Violation oblique_angle(const Value& value, const Value& argument, const std::string& argument_name, double scale) {
  const double length = as_matrix(argument).norm();
  if (length == 0) return {};
  const double product = as_matrix(value).cwiseProduct(as_matrix(argument)).sum();
  Worst worst;
  worst.consider(std::abs(product) / (length * scale),
                 [&] { return messages::product_with_argument_is(argument_name, number_text(product, digits)); });
  return worst.take();
}

Violation drift_violation(const ExerciseReference& exercise, const Property& property, std::size_t case_index,
                          const Value& value) {
  if (value.cols == 0) return {};
  const Case& one = exercise.cases[case_index];
  const Deviation deviation = drift(exercise, property, case_index, value);
  const std::vector<double>& weights = property.weights.at(case_index);
  const double constant = weighted_squares(weights, one.expected).front();
  Worst worst;
  for (std::size_t col = 0; col < deviation.allowed.size(); ++col) {
    const double difference = deviation.difference.numbers[col];
    worst.consider(std::abs(difference) / deviation.allowed[col] * one.tolerance, [&] {
      const auto [yours, right] = distinct_texts(constant + difference, constant, digits);
      return messages::in_column_it_is(col + 1, yours, right);
    });
  }
  return worst.take();
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

std::vector<Diagnosis> diagnose_properties(const ExerciseReference& exercise, const Answers& answers) {
  std::vector<Diagnosis> diagnoses;
  for (const Property& property : exercise.properties) {
    bool all_expected_have_it = true;
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      if (clearly_lacks(exercise, property, i, exercise.cases[i].expected)) all_expected_have_it = false;
    }
    if (!all_expected_have_it) continue;

    for (std::size_t i : deciding_cases(exercise)) {
      if (i >= answers.size() || !answers[i] || !is_finite(*answers[i])) continue;
      if (!clearly_lacks(exercise, property, i, *answers[i])) continue;
      const std::string detail = violation(exercise, property, i, *answers[i]).detail;
      diagnoses.push_back({DiagnosisKind::property, to_string(property.kind),
                           messages::broken_property(property.message, detail, exercise.cases[i].name),
                           property.notes});
      break;
    }
  }
  return diagnoses;
}

}  // namespace workbook
