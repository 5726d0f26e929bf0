/// @file
/// One worker process, and the conversation with it.
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/data/observation.hpp"
#include "checker/data/value.hpp"
#include "checker/sandbox/sandbox.hpp"
#include "checker/worker/protocol.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace workbook {

/// What all calls together may still use.
struct Budget {
  Clock::time_point deadline;
  double processor_seconds = 0.0;
  std::size_t output_bytes = 0;
  std::string printed;  ///< standard output and standard error, as far as the limit lets it through
};

/// Anything but an answer ends the conversation: the worker is then gone, and the next call needs a new one.
class Worker {
 public:
  /// @throws LaunchError
  Worker(Sandbox& sandbox, Budget& budget);
  ~Worker();

  /// Calls the student's function once and waits for what becomes of it.
  /// @param rows, cols  the shape that the result should have
  Reply call(const std::vector<Value>& inputs, int rows, int cols);

  /// Hangs up and waits for the end. Returns a protocol violation if the worker still had something to say.
  Reply finish();

  bool running() const { return running_; }

 private:
  enum class Stop { none, end_of_stream, out_of_time, output_limit };

  /// Exchanges bytes until `wanted` bytes are in `received_`. Prints are collected meanwhile.
  Stop exchange(std::size_t wanted);
  Stop receive_header();
  void send_some();
  Stop receive_some(std::size_t wanted);
  Stop collect_prints();
  bool has_more_to_say() const;
  Reply returned_value(const protocol::ReplyHeader& header, int rows, int cols);

  Reply stopped(Stop reason);
  Reply violation(const std::string& text);
  ProcessEnd end_process();

  Budget& budget_;
  unsigned processor_seconds_;
  ChildProcess process_;
  bool running_ = true;
  bool output_closed_ = false;
  std::vector<char> unsent_;
  std::size_t sent_ = 0;
  std::vector<char> received_;
  protocol::ReplyHeader crash_report_{};
};

}  // namespace workbook
