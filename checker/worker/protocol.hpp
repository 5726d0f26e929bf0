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

struct Shape {
  std::int32_t rows;
  std::int32_t cols;
};

struct RequestHeader {
  std::uint64_t magic;
  std::uint64_t nonce;  ///< random; the reply must repeat it, so that no reply can be older than its request
  std::int32_t arguments;
  Shape result;  ///< the only shape whose numbers the checker is ready to read
  std::int32_t unused;
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
  std::int64_t
      detail;  ///< SIGSYS: the number of the system call; SIGSEGV: stack_used_up or 0; SIGABRT: foreign_exception or 0
  char text[472];  ///< ends with a zero byte
};

inline constexpr std::int64_t stack_used_up = 1;
inline constexpr std::int64_t foreign_exception = 1;

static_assert(sizeof(RequestHeader) == 32 && sizeof(ReplyHeader) == 512, "no padding may travel");

}  // namespace workbook::protocol
