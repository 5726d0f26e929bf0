/// @file
/// A program that runs beside the checker and cannot outlive it: the compiler, and the worker.
#pragma once

#include "checker/base/descriptor.hpp"
#include "checker/messages/starting.hpp"

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace workbook {

using Clock = std::chrono::steady_clock;

/// The program could not be started. The text names the step that failed and the system's reason.
struct LaunchError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What to start. All of it must live until the ChildProcess is made.
struct Launch {
  const char* program = nullptr;         ///< path; nothing is searched, no shell is involved
  std::vector<std::string> arguments;    ///< without the program's own name
  std::vector<std::string> environment;  ///< "NAME=value"; nothing is inherited
  std::filesystem::path directory;       ///< where it starts; empty: where the checker stands
  bool with_channel = false;             ///< a socket pair to talk over, protocol::channel in the new process
  /// Runs in the new process just before the program, and may only make system calls: between fork and exec nothing
  /// else is safe. Returns nothing, or what failed, with the reason in errno.
  std::function<std::optional<messages::LaunchStep>()> prepare;
};

/// How a process ended.
struct ProcessEnd {
  int exit_status = 0;
  int signal = 0;  ///< 0 if the process ended by itself
  double processor_seconds = 0.0;
};

/// A running program with its own process group. Its standard input is empty; standard output and error arrive
/// together. Nothing of it is left when the object is gone. Linux ties its life to the thread that made it: keep that
/// thread.
class ChildProcess {
 public:
  /// @throws LaunchError
  explicit ChildProcess(const Launch& launch);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  int output() const { return output_.number(); }    ///< does not block
  int channel() const { return channel_.number(); }  ///< does not block

  /// Says over the channel that no more will be said.
  void hang_up();

  /// Sends the process a signal, if it still runs.
  void signal(int number);

  /// How the process ended, or nothing if it still runs at that time.
  std::optional<ProcessEnd> wait_until(Clock::time_point deadline);

  /// Sends it the signal to end (SIGTERM), which it may take its time for, or ignore.
  void ask_to_end();

  /// Ends the process and all its children, if any are left.
  ProcessEnd kill();

 private:
  ProcessEnd reap();

  pid_t process_ = -1;
  Descriptor output_;
  Descriptor channel_;
  std::optional<ProcessEnd> end_;
};

/// A program that ran to its end, or to one of its limits.
struct FinishedProgram {
  ProcessEnd end;
  std::string output;
  bool out_of_time = false;
  bool too_much_output = false;

  /// It ended by itself, with exit status 0, within its limits.
  bool succeeded() const { return !out_of_time && !too_much_output && end.signal == 0 && end.exit_status == 0; }
};

/// Runs a program and collects what it prints; a listener hears of every piece as it comes. @throws LaunchError
FinishedProgram run_program(const Launch& launch, std::chrono::duration<double> time_limit, std::size_t output_limit,
                            const std::function<void(std::string_view)>& listener = {});

}  // namespace workbook
