/// @file
/// What the checker says of one exercise.
#pragma once

#include "checker/data/value.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace workbook {

enum class Verdict {
  passed,
  wrong_value,
  non_finite_value,
  wrong_shape,
  not_started,
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

std::string to_string(Verdict verdict);

enum class DiagnosisKind { misconception, term, property, dimension, transform };

std::string to_string(DiagnosisKind kind);

/// Why an answer is wrong. Either true or absent.
struct Diagnosis {
  DiagnosisKind kind = DiagnosisKind::misconception;
  std::string name;
  std::string message;  ///< one sentence
  std::string notes;    ///< anchor of the paragraph to read; may be empty
};

/// The first case that did not pass.
struct FirstFailure {
  std::size_t case_index = 0;
  std::optional<Value> actual;  ///< absent when no value came back
};

struct Judgement {
  Verdict verdict = Verdict::checker_error;
  std::string message;    ///< one sentence that a student understands
  std::string next_step;  ///< what to do about it
  std::size_t cases_passed = 0;
  std::size_t cases_total = 0;
  std::vector<Diagnosis> diagnoses;
  std::optional<FirstFailure> first_failure;

  bool passed() const { return verdict == Verdict::passed; }
};

}  // namespace workbook
