// The diagnostic run of a function that failed reads shared libraries and /proc, so it has a sandbox of its own. What
// it reports is text that the function can write itself.
#include "tests/attacks/attack.hpp"

#include "checker/explain/diagnostic_run.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace workbook::testing {
namespace {

/// What a function must not get either in the run that explains, where it may open what is its own, and nothing that it
/// prints is read.
bool is_tried(const Attack& attack) {
  if (attack.works == prints_pass || attack.what == "the other end of a pipe") return false;
  return attack.kind == "reading at run time" || attack.kind == "the host" || attack.what.starts_with("the disk") ||
         attack.what == "memory, mapped" || attack.what == "processes" || attack.what == "a thread";
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
  const AttackFile file = read_attacks("in_a_call");
  const std::filesystem::path program = diagnostic_program(function_of(file));
  const SandboxProfile profile = diagnose_profile(toolchain().compiler.string(), program.string());
  for (std::size_t k = 0; k < file.attacks.size(); ++k) {
    const Attack& attack = file.attacks[k];
    if (!is_tried(attack)) continue;
    INFO(attack.kind << ": " << attack.what);
    CHECK(attack.works(run_unhindered(program, number_of(k) + 0.5)));
    restore_canary();
    Budget budget{Clock::now() + std::chrono::seconds(20), 10.0, 1 << 16};
    Worker worker(program, profile, budget);
    const Reply reply = worker.call({twice_case(number_of(k)).inputs, 1, 1});
    CHECK_FALSE((reply.ending == Ending::returned && reply.value == Value{1, 1, {42}}));
    CHECK_FALSE((reply.ending == Ending::stopped_early && reply.exit_status == 0));  // as another program
    if (attack.what == "memory, mapped") CHECK(reply.ending == Ending::memory_limit);
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
