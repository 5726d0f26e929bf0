#include "checker/explain/values/diagnosis.hpp"

#include <fmt/format.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace workbook {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double coefficient_tolerance = 1e-6;
constexpr Eigen::Index spare_term_equations = 3;  // an exact fit of so many more equations than terms is no accident

/// The normal equations of the least-squares problem, for columns of length 1, so that large and small terms count
/// alike. A few unknowns need no more accurate decomposition, and this one compiles in a quarter of the time of a QR.
struct NormalEquations {
  explicit NormalEquations(const MatrixXd& columns)
      : lengths(columns.colwise().norm()), unit(columns * lengths.cwiseInverse().asDiagonal()) {
    decomposition.compute(unit.transpose().lazyProduct(unit));
  }
  bool are_independent() const { return lengths.minCoeff() > 0 && decomposition.vectorD().minCoeff() > 1e-12; }
  VectorXd solve(const VectorXd& values) const {
    return decomposition.solve(unit.transpose().lazyProduct(values)).cwiseQuotient(lengths);
  }

  VectorXd lengths;
  MatrixXd unit;
  Eigen::LDLT<MatrixXd> decomposition;
};

bool is_exact(const TermEquations& equations, const VectorXd& coefficients) {
  const VectorXd fitted = equations.terms * coefficients;
  for (Eigen::Index row = 0; row < fitted.size(); ++row) {
    const double size = std::max(1.0, std::abs(equations.values[row]));
    if (!(std::abs(fitted[row] - equations.values[row]) <= equations.tolerance * size)) return false;
  }
  return true;
}

/// A coefficient is known only as well as its term shows in the result.
bool is_clearly_off(const TermEquations& equations, Eigen::Index term, double difference) {
  const double effect = std::abs(difference) * equations.terms.col(term).cwiseAbs().maxCoeff();
  return std::abs(difference) > coefficient_tolerance && effect > clear_margin * equations.tolerance;
}

bool is_multiple_of_right_answer(const VectorXd& coefficients, const VectorXd& right) {
  if (right.size() < 2) return false;
  const double factor = coefficients.dot(right) / right.squaredNorm();
  return (coefficients - factor * right).cwiseAbs().maxCoeff() <= coefficient_tolerance;
}

struct WrongCoefficient {
  std::string term;
  double actual;
  double expected;
};

std::string sentence_of(const std::vector<WrongCoefficient>& wrong) {
  constexpr std::size_t most = 2;
  std::string text;
  for (std::size_t k = 0; k < std::min(wrong.size(), most); ++k) {
    const std::string actual = coefficient_text(wrong[k].actual);
    text += (k == 0 ? "The term " : ", and the term ") + wrong[k].term;
    text += actual == "0" ? " is missing"
                          : fmt::format(" enters with {}, expected {}", actual, coefficient_text(wrong[k].expected));
  }
  const std::size_t others = wrong.size() - std::min(wrong.size(), most);
  if (others > 0) text += fmt::format("; {} more {} off", others, others == 1 ? "is" : "are");
  return text + ".";
}

/// The term that is a multiple of the unit matrix, where one of ones stands in its place and all else is right.
std::optional<Reason> term_of_ones(const ExerciseReference& exercise, const Answers& answers) {
  if (exercise.result_kind != Kind::matrix3) return std::nullopt;
  for (const Term& term : exercise.terms) {
    const bool is_that = std::ranges::all_of(deciding_cases(exercise), [&](std::size_t i) {
      const double size = term.outputs[i].numbers[0];
      MatrixXd with_ones = as_matrix(exercise.cases[i].expected);
      with_ones += term.coefficient * size * (MatrixXd::Ones(3, 3) - MatrixXd::Identity(3, 3));
      return as_matrix(term.outputs[i]) == size * MatrixXd::Identity(3, 3) &&
             is_same_answer(exercise, i, *answers[i], to_value(with_ones));
    });
    const auto vanishes = [&](std::size_t i) { return term.outputs[i].numbers[0] == 0; };
    if (is_that && !std::ranges::all_of(deciding_cases(exercise), vanishes))
      return Reason{ReasonKind::term, term.name,
                    fmt::format("The term {} stands in every entry; it belongs on the diagonal only.", term.name)};
  }
  return std::nullopt;
}

}  // namespace

TermEquations term_equations(const ExerciseReference& exercise, const Answers& values) {
  const std::vector<std::size_t> deciding = deciding_cases(exercise);
  std::size_t rows = 0;
  for (const std::size_t i : deciding) rows += exercise.cases[i].expected.numbers.size();
  TermEquations equations;
  equations.terms.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(exercise.terms.size()));
  equations.values.resize(equations.terms.rows());
  Eigen::Index row = 0;
  for (const std::size_t i : deciding) {
    const Case& one = exercise.cases[i];
    equations.tolerance = std::max(equations.tolerance, one.tolerance);
    for (std::size_t n = 0; n < one.expected.numbers.size(); ++n, ++row) {
      Eigen::Index col = 0;
      for (const Term& term : exercise.terms)
        equations.terms(row, col++) = term.outputs.at(i).numbers.at(n) / scale_at(one, n);
      equations.values[row] = values.at(i)->numbers.at(n) / scale_at(one, n);
    }
  }
  return equations;
}

bool TermEquations::determine_coefficients() const {
  const Eigen::Index unknowns = terms.cols();
  // A row of zeros says nothing about the coefficients.
  const Eigen::Index telling = (terms.array() != 0.0).rowwise().any().count();
  if (unknowns == 0 || telling < unknowns + spare_term_equations) return false;
  return NormalEquations(terms).are_independent();
}

std::optional<Reason> diagnose_terms(const ExerciseReference& exercise, const Answers& answers) {
  if (exercise.terms.empty() || exercise.comparison != Comparison::plain) return std::nullopt;
  if (!all_deciding_cases_answered(exercise, answers)) return std::nullopt;
  if (auto found = term_of_ones(exercise, answers)) return found;
  const TermEquations equations = term_equations(exercise, answers);
  if (!equations.values.allFinite() || !equations.determine_coefficients()) return std::nullopt;

  const VectorXd coefficients = NormalEquations(equations.terms).solve(equations.values);
  if (!is_exact(equations, coefficients)) return std::nullopt;

  VectorXd right(coefficients.size());
  std::vector<WrongCoefficient> wrong;
  for (std::size_t t = 0; t < exercise.terms.size(); ++t) {
    const auto index = static_cast<Eigen::Index>(t);
    right[index] = exercise.terms[t].coefficient;
    if (is_clearly_off(equations, index, coefficients[index] - right[index])) {
      wrong.push_back({exercise.terms[t].name, coefficients[index], right[index]});
    }
  }
  if (wrong.empty() || is_multiple_of_right_answer(coefficients, right)) return std::nullopt;
  // That is no other formula, but a sum or an integration in large steps.
  constexpr double nearly = 2e-2;
  if (std::ranges::all_of(wrong, [](const WrongCoefficient& each) {
        return std::abs(each.actual - each.expected) < nearly * std::abs(each.expected);
      }))
    return std::nullopt;
  // Beside a coefficient that is wrong, one that is off in its last digits is no mistake of its own.
  const auto error = [](const WrongCoefficient& each) { return std::abs(each.actual - each.expected); };
  const double largest = error(*std::ranges::max_element(wrong, {}, error));
  std::erase_if(wrong, [&](const WrongCoefficient& each) { return error(each) < 1e-4 * largest; });
  return Reason{ReasonKind::term, wrong.front().term, sentence_of(wrong)};
}

}  // namespace workbook
