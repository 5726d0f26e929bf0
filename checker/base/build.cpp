#include "checker/base/build.hpp"

#include "checker/base/files.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace workbook {

namespace {

constexpr std::chrono::minutes longest_build{30};
constexpr std::size_t most_output = std::size_t{4} << 20;

Launch launch_of(const std::string& program, const std::vector<std::string>& arguments) {
  const char* const path = std::getenv("PATH");
  Launch launch;
  launch.program = program.c_str();
  launch.arguments = arguments;
  launch.environment = {std::string("PATH=") + (path == nullptr ? "/usr/bin:/bin" : path)};
  return launch;
}

}  // namespace

FinishedProgram make(const Build& build, const std::vector<std::string>& targets) {
  const std::string program = "/usr/bin/env";
  std::vector<std::string> arguments = {"bash", build.setup.string(), "build/" + build.directory.filename().string()};
  arguments.insert(arguments.end(), targets.begin(), targets.end());
  Launch launch = launch_of(program, arguments);
  // The script writes into a pipe; what went wrong is for the caller to say.
  launch.environment.emplace_back(::isatty(STDERR_FILENO) != 0 ? "WORKBOOK_PROGRESS=terminal"
                                                               : "WORKBOOK_PROGRESS=lines");
  FinishedProgram finished = run_program(launch, longest_build, most_output, [](std::string_view piece) {
    fmt::print(stderr, "{}", piece);
    std::fflush(stderr);
  });
  if (!finished.succeeded()) finished.output = read_file(build.directory / "build.log").value_or(finished.output);
  return finished;
}

FinishedProgram run_with_path(const std::string& program, const std::vector<std::string>& arguments,
                              std::chrono::duration<double> limit) {
  return run_program(launch_of(program, arguments), limit, most_output);
}

}  // namespace workbook
