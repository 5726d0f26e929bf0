/// @file
/// What was seen when a student's function ran. The judge needs nothing else of the student.
#pragma once

#include "checker/data/reason.hpp"
#include "checker/data/value.hpp"

#include <functional>
#include <optional>

namespace workbook {

enum class Ending {
  returned,
  not_started,    ///< threw rigid::NotStarted
  exception,      ///< text: what it said; or eigen
  wrong_shape,    ///< value holds only rows and cols, no numbers
  crashed,        ///< signal, cause
  stopped_early,  ///< the process ended by itself; exit_status
  time_limit,
  memory_limit,
  output_limit,
  forbidden_operation,  ///< system_call, where it is known
  protocol_violation,   ///< violation
  not_run               ///< the limits were used up before this call
};

/// Why a process crashed, or what was thrown, as far as the worker could tell.
enum class CrashCause {
  unknown,
  stack_overflow,
  uncaught_exception,  ///< nobody could catch it; text: what it said
  foreign_exception    ///< it was no std::exception and has no text
};

/// Something other than the function answered.
enum class ProtocolViolation {
  not_a_reply,
  another_request,
  too_early,
  impossible_shape,
  unknown_status,
  second_reply,
  after_last_reply,
  closed_channel
};

/// One call of the student's function: what goes in, and the shape that should come out.
struct PlannedCall {
  std::vector<Value> inputs;
  int rows = 1;
  int cols = 1;
};

/// What came of it.
struct Reply {
  Ending ending = Ending::not_run;
  Value value = {};
  std::string text = {};
  std::string printed = {};  ///< what the function wrote to standard output and standard error in this call, as it came
  std::optional<std::string> eigen = {};  ///< the condition of its own that failed: "index >= 0 && index < size()"
  CrashCause cause = CrashCause::unknown;
  ProtocolViolation violation = ProtocolViolation::not_a_reply;
  int signal = 0;
  int exit_status = 0;
  long system_call = -1;  ///< its number; -1: unknown
};

/// A case run once more, in a fresh process.
struct Repeat {
  std::size_t case_index = 0;
  Reply reply;
};

/// Further calls of the function that was judged, with limits of their own.
using Ask = std::function<std::vector<Reply>(const std::vector<PlannedCall>&)>;

/// Why the function never ran.
enum class Refusal { rejected_file, compile_error, missing_function, checker_error };

struct Observation {
  std::optional<Refusal> refusal;
  std::string refusal_message;  ///< one sentence
  std::string refusal_details;  ///< what the compiler printed

  std::vector<Reason> errors;  ///< the first error of the compiler, with its line

  std::vector<Reply> replies;  ///< one per case
  std::vector<Repeat> repeats;
  std::vector<Reply> sweep;     ///< one per point of the plot, where the task asks for them
  std::vector<Reply> measured;  ///< of a function that passes: what it makes of each piece of real data
  std::vector<Reply> further;   ///< of a function that passes: at the inputs that the task adds
  double compile_seconds = 0.0;
  double run_seconds = 0.0;
};

/// What the student's code printed in all calls.
inline std::string printed(const Observation& observation) {
  std::string text;
  for (const Reply& reply : observation.replies) text += reply.printed;
  for (const Repeat& repeat : observation.repeats) text += repeat.reply.printed;
  return text;
}

}  // namespace workbook
