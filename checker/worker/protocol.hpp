/// @file
/// What checker and worker send each other: fixed headers followed by numbers, over one socket pair.
///
/// A request is a RequestHeader, a Shape per argument, then the numbers of all arguments. A reply is a ReplyHeader, and
/// after Status::returned the numbers of the expected shape. The checker therefore knows before it reads how much
/// comes.
#pragma once

#include <cstdint>

namespace workbook::protocol {

/// The worker's end of the socket pair. Standard input, output and error belong to the student.
inline constexpr int channel = 3;

inline constexpr std::uint64_t request_magic = 0x31747365'75716572;
inline constexpr std::uint64_t reply_magic = 0x31796c70'65722020;

/// As a double a NaN that traps at its first use in arithmetic; every calculation changes it.
inline constexpr std::uint64_t never_set = 0x7ff4ab1e'7ff4ab1e;

struct Shape {
  std::int32_t rows;
  std::int32_t cols;
};

/// For a diagnostic run; other workers do not look at it. Bits that may be set together.
enum Mode : std::int32_t {
  plain = 0,            ///< only what the sanitizers see; memory is filled with zeros before the call
  fill_with_nan = 1,    ///< with NaN that trap at their first use instead
  trap_invalid = 2,     ///< the first invalid operation ends the call
  trap_non_finite = 4,  ///< and the first division by zero or overflow
  sample = 8            ///< after a while the call is interrupted again and again, and tells where it is
};

/// Which of several variants of a function is called stands above those bits.
inline constexpr int variant_shift = 8;

struct RequestHeader {
  std::uint64_t magic;
  std::uint64_t nonce;  ///< random; the reply must repeat it, so that no reply can be older than its request
  std::int32_t arguments;
  Shape result;       ///< the only shape whose numbers the checker is ready to read
  std::int32_t mode;  ///< bits of Mode, and the variant
};

enum class Status : std::int32_t {
  returned = 1,
  wrong_shape,  ///< only rows and cols follow from the function's result, no numbers
  not_started,
  exception,  ///< text
  out_of_memory,
  crash_report,      ///< a signal is about to end the worker: signal, detail, text. Believed only if it then does
  eigen_assertion,   ///< text: the condition that did not hold
  foreign_exception  ///< thrown was something that is no std::exception and has no text
};

struct ReplyHeader {
  std::uint64_t magic;
  std::uint64_t nonce;
  Status status;
  Shape result;
  std::int32_t signal;
  std::int64_t detail;  ///< of a crash_report. SIGSYS: the number of the system call; else of CrashDetail
  char text[472];       ///< ends with a zero byte
};

enum CrashDetail : std::int64_t { nothing_known, stack_overflow, exception_with_text, exception_without_text };

static_assert(sizeof(RequestHeader) == 32 && sizeof(ReplyHeader) == 512, "no padding may travel");

}  // namespace workbook::protocol
