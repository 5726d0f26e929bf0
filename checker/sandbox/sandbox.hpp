/// @file
/// The walls around a student's code: limits on what it may use, and a filter of system calls that lets it compute,
/// print, sleep and look at the clock, and nothing else.
#pragma once

#include "checker/messages/starting.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace workbook {

/// The walls cannot be put up; nothing of the student's runs then.
struct SandboxError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What this machine offers.
struct SandboxStrength {
  bool filters_system_calls = false;
  std::string sentence;
};

SandboxStrength sandbox_strength();

/// "open a file (openat)": what a forbidden system call is for, to follow "tried to".
std::string forbidden_operation(long system_call);

struct SandboxLimits {
  std::size_t memory_bytes = std::size_t{512} << 20;
  std::size_t stack_bytes = std::size_t{8} << 20;
};

/// The walls for one program. They go up in the new process before the program starts, so that no line of it runs
/// outside.
class Sandbox {
 public:
  /// @throws SandboxError
  Sandbox(const std::filesystem::path& program, SandboxLimits limits);
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  /// The program's path. The filter lets through exec of exactly this pointer, which means nothing in the program
  /// itself.
  const char* program() const { return program_.c_str(); }

  /// For Launch::prepare; makes system calls only.
  std::optional<messages::LaunchStep> enter(unsigned processor_seconds) noexcept;

 private:
  struct Instruction {  ///< layout of the kernel's sock_filter
    unsigned short code;
    unsigned char if_true;
    unsigned char if_false;
    unsigned int operand;
  };

  void build_filter();

  const std::string program_;
  const SandboxLimits limits_;
  std::vector<Instruction> filter_;  ///< empty where the kernel has no filters
};

}  // namespace workbook
