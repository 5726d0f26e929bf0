#include "checker/compile/compile.hpp"

#include "checker/base/text.hpp"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace workbook {
namespace fs = std::filesystem;

namespace {

constexpr const char* instantiated_name = "instantiated.hpp";

}  // namespace

void Compiler::write(std::string_view source, const std::string& before, const std::string& name) const {
  const auto write_text = [&](const std::string& file, const std::string& text) {
    const std::string problem = write_file(workspace_ / file, text);
    if (!problem.empty())
      throw std::runtime_error(fmt::format("The checker cannot write {} ({}); this is not your mistake.",
                                           (workspace_ / file).string(), problem));
  };
  for (Instantiation& each : instantiations(toolchain_, source))
    if (std::ranges::count(instantiated_, each.object, &Instantiation::object) == 0)
      instantiated_.push_back(std::move(each));
  std::string declarations;
  for (const Instantiation& each : instantiated_) declarations += each.declarations;
  if (!declarations.empty()) write_text(instantiated_name, declarations);
  if (!before.empty() && source.starts_with(byte_order_mark)) source.remove_prefix(byte_order_mark.size());
  // Not without need: after a #line GCC does not look at the indentation.
  write_text(name, before.empty() ? std::string(source) : fmt::format("{}#line 1 \"{}\"\n{}", before, name, source));
}

std::vector<std::string> Compiler::arguments(const std::vector<std::string>& more) const {
  std::vector<std::string> arguments = toolchain_.flags;
  arguments.insert(arguments.end(),
                   {"-pipe", "-fdiagnostics-color=never", "-x", "c++", "-include", toolchain_.prelude.string()});
  if (!instantiated_.empty()) arguments.insert(arguments.end(), {"-include", instantiated_name});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

FinishedProgram Compiler::run(const fs::path& program, std::vector<std::string> arguments,
                              const CompileLimits& limits) const {
  std::vector<std::string> inputs = {toolchain_.prelude.parent_path().string(), toolchain_.directory.string(),
                                     toolchain_.sources.string()};
  for (const fs::path& directory : toolchain_.include_directories) inputs.push_back(directory.string());
  const double left = std::min(limits.time.count(), limits_.time.count() - used_);
  const std::chrono::duration<double> until_deadline = deadline_ - Clock::now();
  if (left <= 0.0 || until_deadline.count() <= 0.0) return {.end = {}, .output = "", .out_of_time = true};
  SandboxProfile profile = compile_profile(toolchain_.compiler.string(), inputs, workspace_.string());
  profile.processor_seconds = static_cast<unsigned>(std::ceil(left));
  profile.memory_bytes = limits.memory_bytes;
  profile.file_bytes = limits.file_bytes;
  Launch launch;
  launch.program = program;
  launch.arguments = std::move(arguments);
  launch.environment = {"PATH=" + environment("PATH", "/usr/local/bin:/usr/bin:/bin"), "LC_ALL=C.UTF-8",
                        "TMPDIR=" + workspace_.string()};
  launch.directory = workspace_;
  confine(launch, profile);
  try {
    FinishedProgram finished = run_program(launch, until_deadline, limits.output_bytes);
    used_ += finished.end.processor_seconds;
    // The limit ends the compiler proper, and the program above it only says that something ended.
    finished.out_of_time = finished.out_of_time || (!finished.succeeded() && finished.end.processor_seconds >= left);
    finished.output = printable(finished.output);
    for (const char* quote : {"‘", "’"}) boost::replace_all(finished.output, quote, "'");
    return finished;
  } catch (const LaunchError& error) {
    throw ToolchainError(
        fmt::format("{} cannot be used ({}); build the workbook again.", program.string(), error.what()));
  }
}

CompilerOutput Compiler::read(std::string_view output, const std::string& shown_name) const {
  return read_compiler_output(output, shown_name, [this](const std::string& file) {
    // Parts of the compiler have no path; the prelude is ours.
    return file.find('/') == std::string::npos || file == toolchain_.prelude || may_be_included(file);
  });
}

bool Compiler::may_be_included(const std::string& name) const {
  const auto is_below = [](const fs::path& file, const fs::path& directory) {
    return std::mismatch(directory.begin(), directory.end(), file.begin(), file.end()).first == directory.end();
  };
  const fs::path path = (workspace_ / name).lexically_normal();
  // The compiler's own: the unit, and the assembler's file, which is gone again.
  if (path.parent_path() == workspace_) return true;
  // clang names what is precompiled too.
  if (path == toolchain_.prelude || path.parent_path() == toolchain_.sources) return true;
  // These mean something else for the compiler than for the checker.
  if (is_below(path, "/proc") || is_below(path, "/dev")) return false;
  std::error_code error;
  const fs::path file = fs::canonical(path, error);
  const bool goes_up = std::ranges::count(fs::path(name), "..") > 0;
  return !error && std::ranges::any_of(toolchain_.include_directories, [&](const fs::path& directory) {
    if (!goes_up && is_below(path, directory)) return true;  // links that lead out of it are the system's own
    const fs::path allowed = fs::canonical(directory, error);
    return !error && is_below(file, allowed);
  });
}

}  // namespace workbook
