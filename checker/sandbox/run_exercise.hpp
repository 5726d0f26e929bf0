/// @file
/// Runs a student's compiled function at many inputs and reports what was seen. No answers, no physics, no judging.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"
#include "checker/sandbox/sandbox.hpp"

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
  SandboxLimits sandbox;
};

/// One call of the student's function: what goes in, and the shape that should come out.
struct PlannedCall {
  std::vector<Value> inputs;
  int rows = 1;
  int cols = 1;
};

class ExerciseRunner {
 public:
  /// @param executable  what compile() made
  /// @throws SandboxError if the walls around the worker cannot be built
  explicit ExerciseRunner(const std::filesystem::path& executable, RunLimits limits = {});

  /// One reply per case; then the cases with the given indices once more, in a fresh process.
  /// If the worker cannot be started at all, the observation is refused with Refusal::checker_error.
  Observation observe(const std::vector<Case>& cases, const std::vector<std::size_t>& repeats);

  /// One reply per call, with limits of its own; what the function prints is dropped.
  /// @throws LaunchError if the worker cannot be started
  std::vector<Reply> evaluate(const std::vector<PlannedCall>& calls);

 private:
  RunLimits limits_;
  Sandbox sandbox_;
};

}  // namespace workbook
