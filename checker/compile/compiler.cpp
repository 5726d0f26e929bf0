#include "checker/compile/compiler.hpp"

#include "checker/base/printable.hpp"
#include "checker/compile/build_cache.hpp"
#include "checker/messages/compiling.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <utility>

namespace workbook {
namespace fs = std::filesystem;
namespace {

/// The name as a string literal of C++.
std::string literal(const std::string& name) {
  std::string text;
  for (const char letter : name) {
    if (letter == '"' || letter == '\\') text += '\\';
    text += letter;
  }
  return '"' + text + '"';
}

void write_file(const fs::path& file, const std::string& content) {
  std::ofstream stream(file, std::ios::binary);
  if (!(stream << content).flush()) throw CacheError(messages::cannot_write(file.string()));
}

}  // namespace

Compiler::Compiler(const Toolchain& toolchain, const CompileLimits& limits, std::string file_name, fs::path workspace)
    : toolchain_(toolchain), limits_(limits), file_name_(std::move(file_name)), workspace_(std::move(workspace)) {}

void Compiler::write(const std::string& source, const std::string& before) const {
  fs::create_directory(shown());
  write_file(shown() / file_name_, source);
  write_file(workspace_ / "unit.cpp", before + "#line 1 " + literal(file_name_) + "\n" + source);
}

std::vector<std::string> Compiler::arguments(const std::vector<std::string>& more) const {
  std::vector<std::string> arguments = toolchain_.flags;
  for (const char* argument : {"-fdiagnostics-color=never", "-fmax-errors=20", "-x", "c++", "-include"})
    arguments.push_back(argument);
  arguments.push_back(toolchain_.prelude.string());
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

FinishedProgram Compiler::run(const std::vector<std::string>& arguments) const {
  const std::string program = toolchain_.compiler.string();
  const char* const path = std::getenv("PATH");
  Launch launch;
  launch.program = program.c_str();
  launch.arguments = arguments;
  launch.environment = {std::string("PATH=") + (path ? path : "/usr/local/bin:/usr/bin:/bin"), "LC_ALL=C",
                        "TMPDIR=" + workspace_.string()};
  launch.directory = shown();
  const rlimit memory{limits_.memory_bytes, limits_.memory_bytes};
  const auto seconds = static_cast<rlim_t>(std::ceil(limits_.time.count()));
  const rlimit processor{seconds, seconds + 1};
  const rlimit core{0, 0};
  const rlimit file{limits_.file_bytes, limits_.file_bytes};
  launch.prepare = [&]() -> std::optional<messages::LaunchStep> {
    const bool limited = ::setrlimit(RLIMIT_AS, &memory) == 0 && ::setrlimit(RLIMIT_CPU, &processor) == 0 &&
                         ::setrlimit(RLIMIT_CORE, &core) == 0 && ::setrlimit(RLIMIT_FSIZE, &file) == 0;
    if (!limited) return messages::LaunchStep::limit_compiler;
    return std::nullopt;
  };
  try {
    FinishedProgram finished = run_program(launch, limits_.time, limits_.output_bytes);
    finished.output = printable(finished.output);
    return finished;
  } catch (const LaunchError& error) {
    throw ToolchainError(messages::compiler_cannot_be_used(program, error.what()));
  }
}

std::string shown_name(const fs::path& file) {
  std::string name = printable(file.filename().string());
  std::replace(name.begin(), name.end(), '\n', '?');
  return name;
}

}  // namespace workbook
