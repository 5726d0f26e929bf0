#include "tests/running/student.hpp"

#include "checker/base/child_process.hpp"
#include "checker/base/text.hpp"
#include "checker/grading/grading.hpp"
#include "checker/sandbox/control_group.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <thread>

namespace workbook::testing {
namespace fs = std::filesystem;

namespace {

constexpr int skipped = 77;  // as ctest knows it
constexpr const char* wanted_tier = "WORKBOOK_TEST_SANDBOX";

/// What this machine lacks for a tier, found out without the checker's own attempts; "": nothing.
std::string lacking_for(const std::string& wanted, uid_t user) {
  const SandboxStrength kernel = what_the_kernel_offers();
  if (!kernel.filters_system_calls) return "the kernel does not filter system calls";
  if (wanted == "reduced" && kernel.landlock == 0) return "the kernel has no Landlock";
  if (!wanted.starts_with("full")) return "";
  if (program_on_path("bwrap").empty()) return "bubblewrap is not installed";
  ForkedJob namespaces(  // doctest, and with it in_another_process(), is not ready yet
      [] {
        const bool is_user = ::geteuid() != 0 || ::setresuid(65534, 65534, 65534) == 0;
        const int all = CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET;
        return std::string(is_user && ::unshare(all) == 0 ? "made" : "");
      },
      std::chrono::minutes(1));
  if (!namespaces.finish().empty() || namespaces.output() != "made") return "users may not make namespaces";
  try {
    if (wanted != "full") control_groups_for(user);
  } catch (const LaunchError& problem) {
    return problem.what();
  }
  return "";
}

/// The strongest tier of this machine, or the one that WORKBOOK_TEST_SANDBOX names.
const SandboxTier tier = [] {
  const uid_t user = grading_user(scratch());
  SandboxStrength strength = probe_sandbox(user);
  const std::string wanted = environment(wanted_tier, to_string(strength.tier()).c_str());
  if (wanted == "full") strength.control_groups.clear();
  if (!wanted.starts_with("full")) strength.namespaces.clear();
  if (wanted == "minimal") strength.landlock = 0;
  if (strength.tier() == SandboxTier::none || to_string(strength.tier()) != wanted) {
    const std::string lacking = lacking_for(wanted, user);
    if (lacking.empty()) {
      fmt::print("This machine has all that the tier {} needs, but the sandbox is {}.\n", wanted, strength.sentence());
      std::exit(1);
    }
    fmt::print("Skipped: there is no tier {} here, because {}.\n", wanted, lacking);
    std::exit(skipped);
  }
  const bool changes_user = strength.tier() >= SandboxTier::full && ::geteuid() == 0;
  if (changes_user) {
    for (const char* exercise : {"twice", "signed_by", "scaled", "counted", "moved"})
      for (const fs::path& file : {fs::path(WORKBOOK_TEST_TOOLCHAIN), toolchain().diagnostic})
        if (!file.empty()) require_complete(read_toolchain(file), exercise);
    fs::create_directories(scratch());
    give_up_root(scratch(), {WORKBOOK_TEST_TOOLCHAIN}, false);
    ::prctl(PR_SET_DUMPABLE, 1);  // as processes of users are
  }
  use_sandbox(strength);
  return strength.tier();
}();

}  // namespace

SandboxTier sandbox_tier() { return tier; }

fs::path scratch() {
  return fs::path(WORKBOOK_TEST_SCRATCH) / environment("WORKBOOK_TEST_PART", "all") /
         environment(wanted_tier, "strongest");
}

const Toolchain& toolchain() {
  static const Toolchain read = read_toolchain(WORKBOOK_TEST_TOOLCHAIN);
  return read;
}

fs::path fresh_directory(const std::string& name) {
  fs::path directory = scratch() / name;
  fs::remove_all(directory);
  fs::create_directories(directory);
  return directory;
}

fs::path shared_cache() { return scratch() / "cache"; }

std::string signature(const std::string& exercise) {
  if (exercise == "twice") return "double twice(double x)";
  if (exercise == "signed_by") return "double signed_by(int n, double x)";
  if (exercise == "scaled") return "Matrix3d scaled(const Matrix3d& A, double factor)";
  if (exercise == "counted") return "VectorXd counted(int n)";
  return "Matrix3Xd moved(const std::vector<Matrix3d>& matrices, const Matrix3Xd& points)";
}

Submission submit(const std::string& text, const std::string& exercise) {
  return {exercise + ".cpp", exercise + ".cpp", text};
}

Compilation compile_text(const std::string& text, const std::string& exercise) {
  return compile({submit(text, exercise), exercise, signature(exercise)}, toolchain(), shared_cache());
}

fs::path executable(const std::string& text, const std::string& exercise) {
  const Compilation compilation = compile_text(text, exercise);
  INFO(compilation.message << "\n" << compilation.details);
  REQUIRE(compilation.executable.has_value());
  return *compilation.executable;
}

Case twice_case(double x) {
  Case one;
  one.inputs = {Value{1, 1, {x}}};
  one.expected = Value{1, 1, {2.0 * x}};
  return one;
}

RunLimits short_limits() {
  RunLimits limits;
  limits.time = std::chrono::seconds(5);
  limits.processor_time = std::chrono::seconds(1);
  limits.sandbox.memory_bytes = std::size_t{128} << 20;
  return limits;
}

Observation run(const std::string& text, const std::vector<double>& inputs, const RunLimits& limits) {
  std::vector<Case> cases(inputs.size());
  std::ranges::transform(inputs, cases.begin(), twice_case);
  ExerciseRunner runner(executable(text), limits);
  return runner.observe(plan_calls(cases), {});
}

std::vector<Snippet> snippets_in(const std::string& file) {
  std::vector<Snippet> all;
  const std::string text = read(fs::path(WORKBOOK_TEST_SOURCES) / file);
  for (const std::string& line : lines_of(text.substr(text.find("\n### ") + 1))) {
    if (const Match head = search(line, R"(^### (.*) \| (.*)$)"))
      all.push_back({head[1], head[2], "", ""});
    else if (all.back().frame.empty())
      all.back().frame = line;
    else
      all.back().text += line + "\n";
  }
  for (Snippet& each : all)
    if (each.frame == "twice" || each.frame == "scaled")
      each.text = fmt::format("namespace rigid {{\n{} {{\n{}}}\n}}\n", signature(each.frame), each.text);
  return all;
}

fs::path golden(const std::string& name) { return fs::path(WORKBOOK_TEST_SOURCES) / "golden" / name; }

bool in_another_process(const std::function<bool()>& something) {
  const pid_t process = ::fork();
  if (process == 0) ::_exit(something() ? 0 : 1);
  int status = 0;
  REQUIRE(::waitpid(process, &status, 0) == process);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace workbook::testing
