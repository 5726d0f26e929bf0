/// @file
/// The compiler at work on a student's file, kept within limits.
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/compile/toolchain.hpp"

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

/// One compilation in its own directory:
///   unit.cpp, unit.o, …   fixed names, whatever the student's file is called
///   shown/NAME            where the compiler starts, and finds the lines that it shows in its messages
class Compiler {
 public:
  /// @param file_name  the name under which the student knows the file, without line ends
  Compiler(const Toolchain& toolchain, const CompileLimits& limits, std::string file_name,
           std::filesystem::path workspace);

  /// Puts the text to be compiled where the compiler finds it; `before` stands before its first line and is not
  /// counted.
  /// @throws CacheError if it cannot be written
  void write(const std::string& source, const std::string& before = {}) const;

  /// Arguments that compile the unit with the flags of the workers, and some more.
  std::vector<std::string> arguments(const std::vector<std::string>& more) const;

  /// Runs the compiler; what it printed comes back safe to show. @throws ToolchainError if it cannot be started
  FinishedProgram run(const std::vector<std::string>& arguments) const;

  const std::filesystem::path& workspace() const { return workspace_; }
  std::filesystem::path shown() const { return workspace_ / "shown"; }
  const std::string& file_name() const { return file_name_; }

 private:
  const Toolchain& toolchain_;
  const CompileLimits& limits_;
  const std::string file_name_;
  const std::filesystem::path workspace_;
};

/// The name of a file as the student knows it, safe to print and on one line.
std::string shown_name(const std::filesystem::path& file);

}  // namespace workbook
