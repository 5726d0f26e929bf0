/// @file
/// Runs a student's compiled function at many inputs and reports what was seen. No answers, no physics, no judging.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"
#include "checker/sandbox/sandbox.hpp"
#include "checker/sandbox/worker_process.hpp"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <vector>

namespace workbook {

/// For all calls of one exercise together.
struct RunLimits {
  std::chrono::duration<double> time{10.0};
  std::chrono::duration<double> processor_time{5.0};
  std::size_t output_bytes = std::size_t{64} << 10;
  SandboxProfile sandbox = run_profile();
};

class ExerciseRunner {
 public:
  /// @param executable  what compile() made
  explicit ExerciseRunner(std::filesystem::path executable, RunLimits limits = {});

  /// One reply per case; then the cases with the given indices once more, in a fresh process.
  /// If the worker cannot be started at all, the observation is refused with Refusal::checker_error.
  Observation observe(const std::vector<Case>& cases, const std::vector<std::size_t>& repeats);

  /// One reply per call, with limits of its own. @throws LaunchError if the worker cannot be started
  std::vector<Reply> evaluate(const std::vector<PlannedCall>& calls);

 private:
  std::filesystem::path executable_;
  RunLimits limits_;
};

}  // namespace workbook
