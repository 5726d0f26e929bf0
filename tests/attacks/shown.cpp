// What of a hostile file is shown: on terminals, in JSON and on pages; and the names that files have.
#include "tests/attacks/attack.hpp"

#include "checker/report/reports.hpp"

#include <doctest/doctest.h>

namespace workbook::testing {
namespace {

/// Everything that is made of a result.
std::string all_reports(const ExerciseReference& reference, const std::string& source, Observation observation) {
  Card card;
  card.lecture = "01_twice";
  card.exercises.resize(1);
  card.exercises[0].name = "twice";
  CheckResult checked;
  checked.task.exercise = {&card, card.exercises.data()};
  checked.source = source;
  checked.reference = &reference;
  checked.judgement = judge(reference, observation);
  checked.reasons = observation.errors;
  checked.observation = std::move(observation);
  ReportedCourse page;
  page.exercises.push_back({checked, {}});
  return report_page(page);
}

struct Name {
  const char* what;
  const char* name;
};

/// What the compiler would take for something else.
const Name names[] = {{"a plugin", "-fplugin=evil.cpp"},
                      {"a wrapper", "-wrapper,evil.cpp"},
                      {"a specification", "-specs=evil.cpp"},
                      {"another language", "-xada.cpp"}};

}  // namespace

TEST_CASE("nothing that a file says acts on a terminal or a page") {
  restore_canary();
  for (const Attack& attack : read_attacks("shown").attacks) {
    INFO(attack.kind << ": " << attack.what);
    const std::string text = filled_in(attack.code);
    const auto begun = std::chrono::steady_clock::now();
    const Compilation compilation = compile_text(text);
    const bool is_run = compilation.executable.has_value();
    CHECK_MESSAGE(attack.works(is_run ? run_unhindered(*compilation.executable, 7) : compile_unhindered(text)),
                  "the control does not work");
    const ExerciseReference reference = reference_at(7);
    const Observation observation =
        is_run ? ExerciseRunner(*compilation.executable, short_limits()).observe(plan_calls(reference.cases), {})
               : refused(compilation);
    expect(attack, reference, observation, begun);
    const std::string page = all_reports(reference, text, observation);
    CHECK_MESSAGE(!is_markup(page), page);
    const std::string said =
        compilation.message + compilation.details + printed(observation) + judge(reference, observation).message;
    CHECK_MESSAGE((!has(said, "\033") && !has(said, "\u202e")), said);
  }
}

TEST_CASE("a name that is an option of the compiler is a name") {
  restore_canary();
  for (const Name& each : names) {
    INFO(std::string(each.what));
    CHECK_FALSE(compiles(compile_unhindered(right_twice, each.name)));
    const auto begun = std::chrono::steady_clock::now();
    const Submission submission{each.name, each.name, right_twice};
    const Compilation compilation = compile({submission, "twice", signature("twice")}, toolchain(), shared_cache());
    REQUIRE(compilation.executable.has_value());
    const ExerciseReference reference = reference_at(7);
    expect({"names", each.what, "", Verdict::passed}, reference,
           ExerciseRunner(*compilation.executable, short_limits()).observe(plan_calls(reference.cases), {}), begun);
  }
}

}  // namespace workbook::testing
