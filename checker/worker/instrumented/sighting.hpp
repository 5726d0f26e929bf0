/// @file
/// What the checker and the witness, the process of the second look, send each other over their socket pair.
///
/// The checker sends one Question, a protocol::Shape per argument and the numbers of all arguments. The witness calls
/// the student's function once and sends a Sighting for everything it notices; after What::returned the numbers of the
/// result follow. The student's code could write there too, so nothing is believed beyond what a sentence may quote.
#pragma once

#include "checker/worker/instrumented/facts.hpp"
#include "checker/worker/protocol.hpp"

#include <cstdint>

namespace workbook::sightings {

inline constexpr std::uint64_t question_magic = 0x3f6b6f6f'6c646e32;
inline constexpr std::uint64_t sighting_magic = 0x216e6565'73646e32;

/// Which results of arithmetic end the call.
enum class Traps : std::int32_t {
  none,
  invalid,     ///< NaN from numbers, and every use of a signalling NaN
  non_finite,  ///< these, division by zero, and numbers that become too large
};

struct Question {
  std::uint64_t magic;
  std::uint64_t nonce;  ///< every sighting must repeat it
  std::int32_t arguments;
  Traps traps;
  std::uint64_t paint;  ///< fills the memory that the function is given, 8 bytes at a time
};

enum class What : std::int32_t {
  returned = 1,        ///< rows, cols; numbers follow unless the shape is the checker's business to refuse
  not_started,         ///< threw rigid::NotStarted
  exception,           ///< text; calls of the place where it was thrown
  out_of_memory,       ///< calls of the place that asked for more
  eigen_assertion,     ///< text: the condition; facts
  library_assertion,   ///< text: the condition; more_text: the function; facts: the two sides
  own_assertion,       ///< text: the condition of an assert() in the student's file
  undefined_behavior,  ///< detail: Undefined; text: the type; facts: the numbers; the call goes on
  terminated,          ///< text: of the exception that nobody could catch
  signal,              ///< signal, detail: its si_code
  stack_used_up,
  forbidden_call,  ///< detail: the number of the system call
  program_ended,   ///< exit() or one of its relatives
  still_running,   ///< the checker has asked where the call is; it goes on
};

/// What the compiler's checks find.
enum class Undefined : std::int32_t {
  sum = 1,
  difference,
  product,
  quotient,
  negative,
  shift,
  index,
  conversion,
  missing_return
};

/// What kind of instruction a floating point trap met.
enum class Arithmetic : std::int32_t { unknown, division, zero_by_zero, root, comparison, conversion, other };

struct Sighting {
  std::uint64_t magic;
  std::uint64_t nonce;
  What what;
  std::int32_t signal;
  std::int64_t detail;
  Arithmetic arithmetic;
  std::int32_t rows;
  std::int32_t cols;
  std::int32_t fact_count;
  std::int64_t facts[Facts::most];
  std::uint64_t address;  ///< that could not be used (SIGSEGV)
  std::int32_t repeated;  ///< how often the most frequent call stands in the whole chain of calls
  std::int32_t call_count;
  std::uint64_t calls[40];  ///< return addresses, innermost first
  char text[440];           ///< ends with a zero byte
  char more_text[200];
};

static_assert(sizeof(Sighting) == 1072, "no padding may travel");

}  // namespace workbook::sightings
