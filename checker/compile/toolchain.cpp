#include "checker/compile/toolchain.hpp"

#include "checker/base/build.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace workbook {

namespace fs = std::filesystem;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Toolchain, compiler, flags, prelude, include_directories, directory, support,
                                   link_flags, nm, second_look, addr2line, main_header, main_function, main_include,
                                   setup, build, target, sources)

namespace {

constexpr int current_toolchain_format = 1;

void require_file(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored))
    throw ToolchainError(fmt::format("{} is missing; build the workbook again.", file.string()));
}

/// Written under another name first: another checker may be making the same.
void make_worker_object(const Toolchain& toolchain, const std::string& exercise) {
  const fs::path source = toolchain.directory / fmt::format("{}.{}.cpp", exercise, getpid());
  const fs::path object = source.string() + ".o";
  std::ofstream(source) << fmt::format("#include \"{}\"\nint main() {{ return workbook::{}(&rigid::{}); }}\n",
                                       toolchain.main_header.string(), toolchain.main_function, exercise);
  std::vector<std::string> arguments = toolchain.flags;
  arguments.insert(arguments.end(), {"-I", toolchain.main_include.string(), "-include", toolchain.prelude.string(),
                                     "-c", source.string(), "-o", object.string()});
  const FinishedProgram compiled = run_with_path(toolchain.compiler.string(), arguments, std::chrono::minutes(2));
  std::error_code problem;
  fs::remove(source, problem);
  if (compiled.succeeded()) fs::rename(object, toolchain.worker_object(exercise), problem);
  if (!compiled.succeeded() || problem)
    throw ToolchainError(fmt::format("The worker of {} could not be compiled{}; does the contract declare it?\n{}",
                                     exercise, problem ? " (" + problem.message() + ")" : "", compiled.output));
}

}  // namespace

Toolchain read_toolchain(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream)
    throw ToolchainError(fmt::format("The toolchain file {} cannot be read; build the workbook again.", file.string()));
  try {
    const auto document = nlohmann::json::parse(stream);
    if (document.at("format") != current_toolchain_format)
      throw ToolchainError(fmt::format(
          "The toolchain file {} has another format than this checker; build the workbook again.", file.string()));
    return document.get<Toolchain>();
  } catch (const nlohmann::json::exception& error) {
    throw ToolchainError(
        fmt::format("The toolchain file {} is damaged ({}); build the workbook again.", file.string(), error.what()));
  }
}

void require_complete(const Toolchain& toolchain, const std::string& exercise) {
  require_file(toolchain.compiler);
  std::vector<fs::path> parts = toolchain.support;
  parts.push_back(toolchain.precompiled());
  std::error_code problem;
  const auto exists = [&](const fs::path& file) { return fs::is_regular_file(file, problem); };
  if (!std::ranges::all_of(parts, exists)) make({toolchain.setup, toolchain.build}, {toolchain.target});
  std::ranges::for_each(parts, require_file);
  const auto made = fs::last_write_time(toolchain.worker_object(exercise), problem);
  const auto is_newer = [&](const fs::path& part) { return fs::last_write_time(part) > made; };
  if (problem || std::ranges::any_of(parts, is_newer)) make_worker_object(toolchain, exercise);
}

}  // namespace workbook
