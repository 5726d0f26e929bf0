/// @file
/// The judge: from what was observed of a student's function to the verdict.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"

namespace workbook {

enum class Verdict {
  passed,
  wrong_value,
  non_finite_value,
  wrong_shape,
  not_started,
  waiting,  ///< fails, and so does an own function of an earlier exercise that it calls
  compile_error,
  missing_function,
  uncaught_exception,
  crashed,
  stopped_early,
  time_limit,
  memory_limit,
  output_limit,
  forbidden_operation,
  protocol_violation,
  inconsistent_value,
  rejected_file,
  checker_error
};

/// "wrong_value"
std::string to_string(Verdict verdict);
void to_json(nlohmann::json& json, const Verdict& verdict);
void from_json(const nlohmann::json& json, Verdict& verdict);

/// "wrong value": of a verdict by its name
std::string in_words(std::string verdict);

struct Judgement {
  Verdict verdict = Verdict::checker_error;
  std::string message;               ///< one sentence that a student understands
  std::string next_step;             ///< what to do about it
  std::vector<std::size_t> failing;  ///< the cases that did not pass, in their order
  std::size_t cases_total = 0;
  std::vector<std::string> waiting_for = {};  ///< own functions that it calls and that fail themselves

  bool passed() const { return verdict == Verdict::passed; }
  std::size_t cases_passed() const { return cases_total - failing.size(); }
};

/// A pure function: the same observation always gets the same judgement. Only values that were compared here can pass;
/// everything that is missing or odd fails.
Judgement judge(const ExerciseReference& exercise, const Observation& observation);

/// The calls of the student's function at these cases: what it is run with knows no expected value.
std::vector<PlannedCall> plan_calls(const std::vector<Case>& cases);

/// The cases to run once more in a fresh process: up to three, in reverse order, so that what a function remembers from
/// an earlier call shows.
std::vector<std::size_t> plan_repeats(const ExerciseReference& exercise);

/// Up to `count` items, evenly spread from the first to the last.
std::vector<std::size_t> evenly_spaced(const std::vector<std::size_t>& items, std::size_t count);

}  // namespace workbook
