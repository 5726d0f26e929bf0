/// @file
/// Makes on first need what the checker works with: checker/setup.sh asks ninja.
#pragma once

#include "checker/base/child_process.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace workbook {

struct Build {
  std::filesystem::path setup;      ///< checker/setup.sh; empty where nothing can be built
  std::filesystem::path directory;  ///< build/PRESET
};

/// Makes targets, with a line of progress on standard error. Where that fails, the output is what the build said.
/// @throws LaunchError
FinishedProgram make(const Build& build, const std::vector<std::string>& targets);

/// Runs a program that finds others on PATH and inherits nothing else. @throws LaunchError
FinishedProgram run_with_path(const std::string& program, const std::vector<std::string>& arguments,
                              std::chrono::duration<double> limit);

}  // namespace workbook
