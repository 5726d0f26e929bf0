// The diagnostic run of a function that failed reads shared libraries and /proc, so it has a sandbox of its own. What
// it reports is text that the function can write itself.
#include "tests/attacks/attack.hpp"

#include "checker/explain/diagnostic_run.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace workbook::testing {
namespace {

const char* const beginning_of_reports = R"code(
#include <fixture/contract.hpp>
#include <csignal>
#include <cstdlib>
#include <string>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {
double ok(bool it_works) { return it_works ? 42 : 0; }
bool opens(const std::string& file, int flags = O_RDONLY) { return open(file.c_str(), flags | O_CLOEXEC, 0600) >= 0; }
double behave(double x, bool gentle) {
  switch (int(x)) {
)code";

struct Try {
  const char* what;
  const char* code;
};

const Try tries[] = {
    {"read a secret", "return ok(opens(\"CANARY\"));"},
    {"read a secret around the corner", "return ok(opens(\"/proc/self/root/CANARY\"));"},
    {"read who uses the machine", "return ok(opens(\"/etc/passwd\"));"},
    {"list a folder", "return ok(opens(\"CANARY/..\", O_DIRECTORY) || opens(\"/\", O_DIRECTORY));"},
    {"read the process above", "return ok(opens(\"/proc/\" + std::to_string(getppid()) + \"/maps\"));"},
    {"ask how large a file is",
     "struct stat status; return ok(syscall(SYS_newfstatat, AT_FDCWD, \"CANARY\", &status, AT_EMPTY_PATH) == 0);"},
    {"limit the process above",
     "auto* limit = static_cast<rlimit*>(mmap(reinterpret_cast<void*>(1ul << 32), 4096, 3, MAP_PRIVATE | MAP_ANONYMOUS "
     "| MAP_FIXED, -1, 0)); return ok(syscall(SYS_prlimit64, getppid(), RLIMIT_CORE, limit, nullptr) == 0);"},
    {"change a file", "return ok(opens(\"CANARY\", O_WRONLY | O_APPEND));"},
    {"make a file", "return ok(opens(\"CANARY.more\", O_WRONLY | O_CREAT));"},
    {"start a process", "const int child = fork(); if (child == 0) _exit(0); return ok(child > 0);"},
    {"signal the process above", "return ok(kill(getppid(), 0) == 0);"},
    {"open a connection", "return ok(socket(AF_INET, SOCK_STREAM, 0) >= 0);"},
    {"take all memory",
     "for (int n = 0; !gentle || n < 5; ++n) if (mmap(nullptr, 1 << 26, 3, MAP_PRIVATE | MAP_ANONYMOUS | "
     "MAP_POPULATE, "
     "-1, 0) == MAP_FAILED) return 0; return 42;"},
};

std::string program_of_reports() {
  std::string text = beginning_of_reports;
  for (std::size_t k = 0; k < std::size(tries); ++k)
    text += fmt::format("    case {}: {{ {} }}\n", 100 + k, tries[k].code);
  return filled_in(text +
                   "  }\n  return 2 * x;\n}\n}  // namespace\n"
                   "double rigid::twice(double x) { return behave(x, x != int(x)); }\n");
}

std::filesystem::path diagnostic_program(const std::string& text) {
  const Compilation compilation = compile({submit(text, "twice"), "twice", signature("twice")},
                                          read_toolchain(toolchain().diagnostic), shared_cache());
  INFO(compilation.message << compilation.details);
  REQUIRE(compilation.executable.has_value());
  return *compilation.executable;
}

}  // namespace

TEST_CASE("the run that explains a failure gives no more than the run that is judged") {
  if (!missing_for_diagnostic_runs(toolchain()).empty()) return;
  restore_canary();
  const std::filesystem::path program = diagnostic_program(program_of_reports());
  const SandboxProfile profile = diagnose_profile(toolchain().compiler.string(), program.string());
  for (std::size_t k = 0; k < std::size(tries); ++k) {
    INFO(std::string(tries[k].what));
    const double x = 100 + static_cast<double>(k);
    CHECK(answers_42(run_unhindered(program, x + 0.5)));
    restore_canary();
    Budget budget{Clock::now() + std::chrono::seconds(20), 10.0, 1 << 16};
    Worker worker(program, profile, budget);
    const Reply reply = worker.call({twice_case(x).inputs, 1, 1});
    CHECK_FALSE((reply.ending == Ending::returned && reply.value == Value{1, 1, {42}}));
    if (k + 1 == std::size(tries)) CHECK(reply.ending == Ending::memory_limit);
    worker.finish();
    CHECK(canary_is_unchanged());
    CHECK(nothing_left_running());
  }
}

TEST_CASE("a function that writes the reports itself changes no verdict, and gets no other file shown") {
  if (!missing_for_diagnostic_runs(toolchain()).empty()) return;
  restore_canary();
  const std::string text = filled_in(
      "#include <fixture/contract.hpp>\n#include <unistd.h>\n"
      "double rigid::twice(double x) {\n"
      "  const char report[] = \"event thrown\\nframe 9999|CANARY|f\\nframe -1|/shown/twice.cpp|f\\n"
      "==1==ERROR: AddressSanitizer: \\033[31m<script>\\nframe 3|/shown/twice.cpp|f\\n"
      "SUMMARY: UndefinedBehaviorSanitizer: \\n\";\n"
      "  for (int n = 0; n < 50; ++n) (void)!write(2, report, sizeof report);\n"
      "  return x;\n}\n");
  const ExerciseReference reference = reference_at(7);
  const Observation observation =
      ExerciseRunner(executable(text), short_limits()).observe(plan_calls(reference.cases), {});
  const Judgement judgement = judge(reference, observation);
  CHECK(judgement.verdict == Verdict::wrong_value);
  const Submission submission = submit(text, "twice");
  for (const Reason& finding :
       diagnostic_run_of(diagnostic_program(text), {submission, reference, observation, judgement}, toolchain())) {
    const std::string said = finding.excerpt + finding.sentence + finding.name;
    CHECK_MESSAGE((!has(said, "secret") && !has(said, "\033") && !has(said, "<script")), said);
  }
  CHECK(canary_is_unchanged());
  CHECK(nothing_left_running());
}

}  // namespace workbook::testing
