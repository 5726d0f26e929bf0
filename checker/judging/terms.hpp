/// @file
/// Finding a wrong coefficient: which sum of the formula's terms did the student compute?
#pragma once

#include "checker/judging/answers.hpp"
#include "checker/judging/judgement.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace workbook {

/// The terms as columns and the given values as a vector, one row per number of every deciding case, each divided by
/// its natural size.
struct TermEquations {
  Eigen::MatrixXd terms;
  Eigen::VectorXd values;
  double tolerance = 0.0;  ///< the widest of the cases
};

/// @pre every deciding case has a value.
TermEquations term_equations(const ExerciseReference& exercise, const Answers& values);

/// True if there are clearly more equations than terms, and no term is a combination of the others.
bool determine_coefficients(const TermEquations& equations);

/// Says which coefficients are off, if the student's answers are exactly a sum of the terms. Silent where the whole
/// answer is a multiple of the right one, which is better said of the whole.
std::optional<Diagnosis> diagnose_terms(const ExerciseReference& exercise, const Answers& answers);

}  // namespace workbook
