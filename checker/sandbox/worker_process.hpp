/// @file
/// Runs a student's compiled function at many inputs, in worker processes, and reports what was seen. No answers, no
/// physics, no judging.
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/data/observation.hpp"
#include "checker/sandbox/sandbox.hpp"
#include "checker/worker/protocol.hpp"

namespace workbook {

/// What all calls together may still use.
struct Budget {
  Clock::time_point deadline;  ///< moves on while others have the processors
  double processor_seconds = 0.0;
  std::size_t output_bytes = 0;
};

/// Anything but an answer ends the conversation: the worker is then gone, and the next call needs a new one.
class Worker {
 public:
  /// @throws LaunchError
  Worker(const Program& program, SandboxProfile profile, Budget& budget);
  ~Worker() { end_process(); }

  /// Calls the student's function once and waits for what becomes of it. @param mode  bits of protocol::Mode
  Reply call(const PlannedCall& call, std::int32_t mode = protocol::plain);

  /// Closes its side and waits for the end. Returns a protocol violation if the worker still had something to say.
  Reply finish();

  bool running() const { return running_; }

 private:
  Reply answer(const PlannedCall& call, std::uint64_t nonce);
  Reply returned(const protocol::ReplyHeader& header, const PlannedCall& call);

  /// Exchanges bytes until `wanted` bytes are in `received_`. Prints are collected meanwhile. Returns Ending::returned,
  /// or what came in between; stopped_early is the end of the stream.
  Ending exchange(std::size_t wanted);
  Ending receive_header();
  void send_some();
  Ending receive_some(std::size_t wanted);
  Ending collect_prints();
  bool uses_too_much_memory() const;
  /// The time for which the process was ready to run and others had the processors, where it was not added before.
  bool extend_deadline();

  Reply stopped(Ending reason);
  Reply violated(ProtocolViolation violation);
  ProcessEnd end_process();

  Budget& budget_;
  SandboxProfile profile_;
  ChildProcess process_;
  bool running_ = true;
  bool output_closed_ = false;
  Clock::duration extended_{0};
  std::string printed_;
  std::vector<char> unsent_;
  std::size_t sent_ = 0;
  std::vector<char> received_;
  std::optional<protocol::ReplyHeader> crash_report_;
};

/// For all calls of one exercise together.
struct RunLimits {
  limits::Seconds time = limits::run_time;
  limits::Seconds processor_time = limits::run_processor_time;
  std::size_t output_bytes = limits::run_output;
  SandboxProfile sandbox = run_profile();
};

class ExerciseRunner {
 public:
  /// @param executable  what compile() made
  explicit ExerciseRunner(Program executable, RunLimits limits = {})
      : executable_(std::move(executable)), limits_(std::move(limits)) {}

  /// One reply per call; then the calls with the given indices once more, in a fresh process.
  /// If the worker cannot be started at all, the observation is refused with Refusal::checker_error.
  Observation observe(const std::vector<PlannedCall>& calls, const std::vector<std::size_t>& repeats);

  /// One reply per call, with limits of its own. @throws LaunchError if the worker cannot be started
  std::vector<Reply> evaluate(const std::vector<PlannedCall>& calls);

 private:
  Program executable_;
  RunLimits limits_;
};

}  // namespace workbook
