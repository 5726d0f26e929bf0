/// @file
/// The checker, started by itself for one command, whose output is collected.
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/report/console.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace workbook {

/// One running command of the checker. It is ended with this object, together with all that it has started.
class CheckerProcess {
 public:
  /// Starts `checker --course FILE ARGUMENTS…`, with the console's width and colours and otherwise our environment.
  /// @throws LaunchError
  CheckerProcess(const std::filesystem::path& course_file, const std::vector<std::string>& arguments,
                 const Console& console);
  ~CheckerProcess();
  CheckerProcess(const CheckerProcess&) = delete;
  CheckerProcess& operator=(const CheckerProcess&) = delete;

  /// Becomes readable when there is something to collect.
  int descriptor() const { return process_->output(); }

  /// Takes what was printed so far. True once the command has closed its output, which is when it ends.
  bool collect();

  /// How it ended. @pre collect() has returned true
  ProcessEnd end();

  const std::string& output() const { return output_; }
  Clock::time_point begun() const { return begun_; }

 private:
  std::string output_;
  Clock::time_point begun_ = Clock::now();
  std::unique_ptr<ChildProcess> process_;
};

}  // namespace workbook
