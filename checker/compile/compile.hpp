/// @file
/// From a student's file to an executable worker.
#pragma once

#include "checker/compile/build_cache.hpp"
#include "checker/compile/toolchain.hpp"
#include "checker/judging/observation.hpp"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace workbook {

/// What the compiler may use for one file.
struct CompileLimits {
  std::chrono::duration<double> time{60.0};
  std::size_t memory_bytes = std::size_t{2} << 30;
  std::size_t output_bytes = std::size_t{256} << 10;
  std::size_t file_bytes = std::size_t{64} << 20;  ///< of each file that it writes
};

/// The exercise that the file is for.
struct CompileTask {
  std::filesystem::path file;
  std::string exercise;   ///< its worker is found under this name
  std::string signature;  ///< as the contract declares it
};

struct Compilation {
  std::optional<std::filesystem::path> executable;
  bool from_cache = false;
  double seconds = 0.0;

  // Where there is no executable:
  Refusal refusal = Refusal::checker_error;
  std::string message;  ///< one sentence
  std::string details;  ///< what the compiler printed
};

/// Compiles the file alone, from a copy, and links it with the worker of its exercise. Never throws for anything that a
/// student or a broken installation can cause.
Compilation compile(const CompileTask& task, const Toolchain& toolchain, const std::filesystem::path& cache_directory,
                    const CompileLimits& limits = {});

/// What to judge where nothing could run. @pre there is no executable
Observation refused(const Compilation& compilation);

}  // namespace workbook
