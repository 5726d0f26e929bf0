/// @file
/// The compiler at work on a student's file, kept within limits.
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/compile/diagnostics.hpp"
#include "checker/compile/toolchain.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace workbook {

/// What the compiler may use for one file.
struct CompileLimits {
  std::chrono::duration<double> time{60.0};
  std::size_t memory_bytes = std::size_t{2} << 30;
  std::size_t output_bytes = std::size_t{256} << 10;
  std::size_t file_bytes = std::size_t{64} << 20;  ///< of each file that it writes
};

/// Compilations in one directory, where the file is called unit.cpp, whatever its name is.
class Compiler {
 public:
  Compiler(const Toolchain& toolchain, const CompileLimits& limits, std::filesystem::path workspace)
      : toolchain_(toolchain), limits_(limits), workspace_(std::move(workspace)) {}

  /// Writes unit.cpp; `before` stands before its first line and is not counted.
  /// @throws CacheError if it cannot be written
  void write(std::string_view source, const std::string& before = {}) const;

  /// Arguments that compile with the flags of the workers, and some more.
  std::vector<std::string> arguments(const std::vector<std::string>& more) const;

  /// Runs the compiler; what it printed comes back safe to show. @throws ToolchainError if it cannot be started
  FinishedProgram run(std::vector<std::string> arguments) const {
    return run(toolchain_.compiler, std::move(arguments), limits_);
  }

  /// Runs nm, which takes a moment and little memory unless a name in the object is made to need more.
  FinishedProgram run_nm(std::vector<std::string> arguments) const {
    return run(toolchain_.nm, std::move(arguments), {.time = std::chrono::seconds(5), .memory_bytes = 256u << 20});
  }

  /// Takes apart what it printed.
  CompilerOutput read(std::string_view output, const std::string& shown_name) const;

  /// May a student's file include this one? Headers of the course and of the system only: others hold the answers.
  bool may_be_included(const std::string& file) const;

  const std::filesystem::path& workspace() const { return workspace_; }

 private:
  SandboxProfile profile(const CompileLimits& limits) const;
  FinishedProgram run(const std::filesystem::path& program, std::vector<std::string> arguments,
                      const CompileLimits& limits) const;

  const Toolchain& toolchain_;
  const CompileLimits& limits_;
  const std::filesystem::path workspace_;
};

}  // namespace workbook
