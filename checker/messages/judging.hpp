/// @file
/// Everything that the judge says to a student, in one place.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"
#include "checker/judging/judgement.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace workbook::messages {

/// What happened, and what to do about it: one sentence each.
struct Advice {
  std::string message;
  std::string next_step;
};

// --- verdicts

Advice passed(std::size_t cases);
Advice refused(Refusal refusal, const std::string& message, const std::string& signature);
Advice no_cases(const std::string& exercise);

/// A repeat came back of a case that the exercise does not have: our fault.
Advice repeat_of_no_case();

Advice not_started();

/// A call that gave no value; not for Ending::returned.
Advice no_value(const ExerciseReference& exercise, const Case& one, const Reply& reply);

/// The repeat of a case ended without a value, although the case had passed.
Advice no_value_when_repeated(const ExerciseReference& exercise, const Case& one, const Reply& reply);

Advice missing_reply(const Case& one);
Advice surplus_replies(std::size_t replies, std::size_t cases);
Advice damaged_value(const Case& one);
Advice wrong_shape(const Case& one, Kind kind, const Value& actual);
Advice non_finite(const Case& one, Kind kind, const Value& actual);
Advice wrong_value(const Case& one, std::size_t cases_passed, std::size_t cases_total, bool is_diagnosed);
Advice inconsistent(const Case& one, Kind kind, const Value& first, const Value& again);

// --- diagnoses

struct WrongCoefficient {
  std::string term;
  double actual = 0.0;
  double expected = 0.0;
};

/// "The term ω×v enters with 1, expected 2."
std::string wrong_coefficients(const std::vector<WrongCoefficient>& wrong);

std::string common_factor(double factor);
std::string degrees_for_radians();
std::string radians_taken_for_degrees();
std::string transposed();
std::string reversed_components();

/// `order[i]` is the component of the right result that stands in the student's component i; both counted from 0.
std::string permuted_components(const std::vector<int>& order);

/// `property` is what the lecture says of right results.
std::string broken_property(const std::string& property, const std::string& detail, const std::string& case_name);

/// Growths are powers of ten; `component` is counted from 1.
std::string wrong_power(char base, double expected_decades, double actual_decades,
                        std::optional<std::size_t> component);
std::string no_single_power(char base, std::optional<std::size_t> component);

// --- size of an error

/// "The error is about 5 % of the size of the result: ..." for an error relative to the natural size.
std::string error_size(double relative, double tolerance);

}  // namespace workbook::messages
