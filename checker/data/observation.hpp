/// @file
/// What was seen when a student's function ran. The judge needs nothing else of the student.
#pragma once

#include "checker/data/value.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace workbook {

/// How one call of the student's function ended.
enum class Ending {
  returned,
  not_started,    ///< threw rigid::NotStarted
  exception,      ///< text: what it said
  wrong_shape,    ///< value holds only rows and cols, no numbers
  crashed,        ///< signal
  stopped_early,  ///< the process ended by itself; exit_status
  time_limit,
  memory_limit,
  output_limit,
  forbidden_operation,  ///< text: which, where it is known
  protocol_violation,   ///< text: what was odd
  not_run               ///< the limits were used up before this call
};

struct Reply {
  Ending ending = Ending::not_run;
  Value value;
  std::string text;
  int signal = 0;
  int exit_status = 0;
};

/// A case run once more, in a fresh process.
struct Repeat {
  std::size_t case_index = 0;
  Reply reply;
};

/// The replies at inputs whose numbers were converted to a smaller unit.
struct UnitProbe {
  char base = 'm';        ///< 'k' kilogram → gram, 'm' metre → centimetre, 's' second → millisecond
  double factor = 100.0;  ///< how many small units make a base unit
  std::vector<std::size_t> case_indices;
  std::vector<Reply> replies;
};

/// Why the function never ran.
enum class Refusal { rejected_file, compile_error, missing_function, checker_error };

/// Something in the student's file that is certainly so and may be what is wrong. It is a help and never a grade.
struct Finding {
  int line = 0;          ///< in the student's file; 0: no single line
  std::string excerpt;   ///< that line as the student wrote it, and below it a caret; may be empty
  std::string sentence;  ///< what is to be said of it
  std::string name;      ///< of the kind of mistake, "integer_division"; the same in `check --json`
  int column = 0;        ///< in that line, from 1; 0: none
};

struct Observation {
  std::optional<Refusal> refusal;
  std::string refusal_message;  ///< one sentence
  std::string refusal_details;  ///< what the compiler printed

  std::vector<Finding> findings;  ///< the first compiler error, or what a closer look at a failure brought to light

  std::vector<Reply> replies;  ///< one per case
  std::vector<Repeat> repeats;
  std::vector<UnitProbe> probes;  ///< taken only after a wrong value
  std::string printed;            ///< what the student's code wrote to standard output and standard error, as it came
  double compile_seconds = 0.0;
  double run_seconds = 0.0;
};

}  // namespace workbook
