#include "checker/compile/toolchain.hpp"

#include "checker/base/child_process.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>

namespace workbook {

namespace fs = std::filesystem;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Toolchain, compiler, flags, prelude, include_directories, directory, support,
                                   link_flags, nm, diagnostic, main_header, main_function, main_include, setup, build,
                                   target, sources)

namespace {

constexpr int toolchain_format = 1;

}  // namespace

Toolchain read_toolchain(const fs::path& file) {
  const auto refuse = [&](const std::string& reason) {
    return ToolchainError(fmt::format("The toolchain file {} {}; build the workbook again.", file.string(), reason));
  };
  const std::optional<std::string> text = read_file(file);
  if (!text) throw refuse("cannot be read");
  try {
    const auto document = nlohmann::json::parse(*text);
    if (document.at("format") != toolchain_format) throw refuse("has another format than this checker");
    return document.get<Toolchain>();
  } catch (const nlohmann::json::exception& error) {
    throw refuse(fmt::format("is damaged ({})", error.what()));
  }
}

std::string make_object(const Toolchain& toolchain, const fs::path& object, const std::string& text) {
  std::error_code problem;
  const auto made = fs::last_write_time(object, problem);
  if (!problem && std::ranges::all_of(toolchain.support,
                                      [&](const fs::path& part) { return fs::last_write_time(part, problem) <= made; }))
    return "";
  // Written under another name first: another checker may be making the same.
  const std::string draft = fmt::format("{}.{}", object.string(), getpid());
  if (std::string unwritable = write_file(draft + ".cpp", text); !unwritable.empty()) return unwritable;
  std::vector<std::string> arguments = toolchain.flags;
  arguments.insert(arguments.end(), {"-I", toolchain.main_include.string(), "-include", toolchain.prelude.string(),
                                     "-c", draft + ".cpp", "-o", draft});
  const FinishedProgram compiled = run_with_path(toolchain.compiler.string(), arguments, std::chrono::minutes(2));
  fs::remove(draft + ".cpp", problem);
  if (!compiled.succeeded()) return compiled.output.empty() ? "The compiler stopped early." : compiled.output;
  fs::rename(draft, object, problem);
  return problem ? problem.message() : "";
}

void require_complete(const Toolchain& toolchain, const std::string& exercise) {
  std::vector<fs::path> parts = toolchain.support;
  parts.push_back(toolchain.precompiled());
  std::error_code problem;
  const auto exists = [&](const fs::path& file) { return fs::is_regular_file(file, problem); };
  if (exists(toolchain.compiler) && !std::ranges::all_of(parts, exists))
    make({toolchain.setup, toolchain.build}, {toolchain.target});
  parts.push_back(toolchain.compiler);
  for (const fs::path& part : parts)
    if (!exists(part)) throw ToolchainError(fmt::format("{} is missing; build the workbook again.", part.string()));
  const std::string main = fmt::format("#include \"{}\"\nint main() {{ return workbook::{}(&rigid::{}); }}\n",
                                       toolchain.main_header.string(), toolchain.main_function, exercise);
  if (const std::string reason = make_object(toolchain, toolchain.worker_object(exercise), main); !reason.empty())
    throw ToolchainError(
        fmt::format("The worker of {} could not be compiled; does the contract declare it?\n{}", exercise, reason));
}

}  // namespace workbook
