/// @file
/// A piece of work in a process of its own, a copy of this one, that hands back bytes.
#pragma once

#include "checker/base/descriptor.hpp"

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace workbook {

/// The process is ended with this object. It dies with the thread that made it, and what it has started itself
/// dies with it (see ChildProcess). Make it while no other thread runs.
class ForkedJob {
 public:
  using Clock = std::chrono::steady_clock;

  /// Hands over bytes while the work goes on.
  using Send = std::function<void(std::string_view)>;

  /// @param work  returns the last bytes; what it throws counts as a failure
  ForkedJob(const std::function<std::string(const Send&)>& work, Clock::duration time_limit);
  ForkedJob(const std::function<std::string()>& work, Clock::duration time_limit)
      : ForkedJob([&work](const Send&) { return work(); }, time_limit) {}
  ~ForkedJob();
  ForkedJob(const ForkedJob&) = delete;
  ForkedJob& operator=(const ForkedJob&) = delete;

  /// Becomes readable when there is something to collect.
  int descriptor() const { return bytes_.number(); }
  /// Takes what has come so far, without waiting. True once the job has closed its end.
  bool collect();
  /// Waits for the end. Returns "" if the job handed over its bytes, or what happened instead.
  std::string finish();

  const std::string& output() const { return output_; }
  Clock::time_point begun() const { return begun_; }

 private:
  void end();

  Clock::time_point begun_ = Clock::now();
  Clock::time_point deadline_;
  pid_t process_ = -1;
  Descriptor bytes_;
  std::string output_;
  bool closed_ = false;
};

}  // namespace workbook
