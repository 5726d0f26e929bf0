/// @file
/// From a student's file to an executable worker.
#pragma once

#include "checker/compile/build_cache.hpp"
#include "checker/compile/compiler.hpp"
#include "checker/compile/toolchain.hpp"
#include "checker/data/observation.hpp"
#include "checker/source/submission.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace workbook {

/// A file, and the exercise that it is for.
struct CompileTask {
  const Submission& submission;
  std::string exercise;   ///< its worker is found under this name
  std::string signature;  ///< as the contract declares it
};

struct Compilation {
  std::optional<std::filesystem::path> executable = {};
  bool from_cache = false;
  double seconds = 0.0;
  std::string compiler_output = {};  ///< the warnings, for source_findings()

  // Where there is no executable:
  Refusal refusal = Refusal::checker_error;
  std::string message;            ///< one sentence
  std::string details;            ///< the errors as the compiler printed them
  std::vector<Finding> findings;  ///< the first error, with its line
};

/// Compiles the file alone and links it with the worker of its exercise. Never throws for anything that a student or a
/// broken installation can cause.
Compilation compile(const CompileTask& task, const Toolchain& toolchain, const std::filesystem::path& cache_directory,
                    const CompileLimits& limits = {});

/// What to judge where nothing could run. @pre there is no executable
Observation refused(const Compilation& compilation);

}  // namespace workbook
