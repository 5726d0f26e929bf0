/// @file
/// The student's values, sorted by case: all that the diagnoses look at.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace workbook {

/// One per case; empty where no value of the right shape came back. A value may hold NaN.
using Answers = std::vector<std::optional<Value>>;

/// True if the value has as many numbers as its shape says.
bool is_complete(const Value& value);

/// True if a complete value of the shape of the expected one came back.
bool has_usable_value(const Reply& reply, const Case& one);

Answers answers_of(const ExerciseReference& exercise, const std::vector<Reply>& replies);

/// The cases at which wrong answers cannot be right.
std::vector<std::size_t> deciding_cases(const ExerciseReference& exercise);

/// True if every deciding case has an answer: only then can a whole answer be recognised.
bool all_deciding_cases_answered(const ExerciseReference& exercise, const Answers& answers);

}  // namespace workbook
