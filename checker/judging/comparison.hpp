/// @file
/// Comparing an answer with the expected one, with the freedom that the exercise leaves.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"

namespace workbook {

/// How many times the tolerance a deviation must be to be told from rounding.
inline constexpr double clear_margin = 10.0;

/// One way in which an answer is measured against the expected one.
struct Deviation {
  std::string meaning;  ///< "yours − expected"
  Kind kind = Kind::number;
  Value difference;             ///< zero for a perfect answer
  double tolerance = 0.0;       ///< relative
  std::vector<double> allowed;  ///< one per number: tolerance × natural size
  bool is_entrywise = false;    ///< true if its numbers belong one by one to those of the result

  /// `<=`, so that NaN is never within.
  bool is_within(std::size_t number) const;
  bool is_within() const;

  /// The largest difference over its natural size.
  double relative_size() const;
};

/// The natural size of one number of the result.
double scale_at(const Case& one, std::size_t number);

/// True if a complete value of the shape of the expected one came back. It may hold NaN.
bool has_usable_value(const Reply& reply, const Case& one);

/// The usable values of a student, one per case; empty where there is none.
using Answers = std::vector<std::optional<Value>>;
Answers answers_of(const ExerciseReference& exercise, const std::vector<Reply>& replies);

/// The cases at which wrong answers cannot be right.
std::vector<std::size_t> deciding_cases(const ExerciseReference& exercise);

/// True if every deciding case has an answer: only then can a whole answer be recognised.
bool all_deciding_cases_answered(const ExerciseReference& exercise, const Answers& answers);

/// The expected value, or its negative where the exercise is compared up to sign and the negative is nearer.
Value nearest_expected(const ExerciseReference& exercise, std::size_t case_index, const Value& actual);

/// How far an answer is from the expected one, in each way in which it is measured, an entrywise one first; the answer
/// must have the expected shape.
std::vector<Deviation> deviations(const ExerciseReference& exercise, std::size_t case_index, const Value& actual);

/// How far Σ weightᵢ yᵢ² of every column is from its one right value. It is measured against its own size: it is
/// conserved better than the entries are known. The answer must have columns, as many as the expected one.
Deviation invariant_deviation(const ExerciseReference& exercise, const Property& property, std::size_t case_index,
                const Value& actual);

/// True if the answer is right: of the expected shape and within the tolerance in every way.
bool passes(const ExerciseReference& exercise, std::size_t case_index, const Value& actual);

/// True if two answers, right or wrong, are one answer: they agree within the case's tolerance, and what is not finite
/// in one is not finite in the other. The exercise's freedom counts: a sign, the sign of each eigenvector, angles of
/// the same attitude.
bool is_same_answer(const ExerciseReference& exercise, std::size_t case_index, const Value& one, const Value& other);

/// Σ weightᵢ yᵢ² of every column.
std::vector<double> weighted_squares(const std::vector<double>& weights, const Value& value);

}  // namespace workbook
