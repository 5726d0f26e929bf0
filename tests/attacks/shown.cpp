// What of a hostile file is shown: on terminals, in JSON and on pages; and the names that files have.
#include "tests/attacks/attack.hpp"

#include "checker/report/reports.hpp"

#include <doctest/doctest.h>

namespace workbook::testing {
namespace {

using enum Verdict;

// An escape sequence, a tag of HTML, and the letter that turns the direction of writing round.
#define HOSTILE "\\033[2J<script>alert(1)</script>\\u202e"
#define RIGHT "double rigid::twice(double x) { return 2 * x; }\n"

bool is_hostile(const std::string& text) { return has(text, "\033") || has(text, "<script>") || has(text, "\u202e"); }
bool prints_it(const Unhindered& control) { return is_hostile(control.printed); }
bool compiler_says_it(const Unhindered& control) { return is_hostile(control.compiler.output); }
bool worker_says_it(const Unhindered& control) { return is_hostile(control.answer); }

const Attack texts_of_attacks[] = {
    {"escapes", "in what is printed",
     "#include <cstdio>\ndouble rigid::twice(double x) { puts(\"" HOSTILE "\"); return x; }\n", wrong_value, prints_it},
    {"escapes", "in an exception",
     "#include <stdexcept>\ndouble rigid::twice(double) { throw std::runtime_error(\"" HOSTILE "\"); }\n",
     uncaught_exception, worker_says_it},
    {"escapes", "in an exception that nobody catches",
     "#include <stdexcept>\nvoid careless() noexcept { throw std::runtime_error(\"" HOSTILE
     "\"); }\ndouble rigid::twice(double) { careless(); return 0; }\n",
     crashed, worker_says_it},
    {"escapes", "in an assertion",
     "#undef NDEBUG\n#include <cassert>\ndouble rigid::twice(double x) { assert(x < 0 && \"<script>\"); return x; }\n",
     crashed, prints_it},
    {"escapes", "in a message of the compiler", "static_assert(false, \"\\x1b[2J<script>alert(1)</script>\");\n" RIGHT,
     compile_error, compiler_says_it},
    {"escapes", "in an error", "#error \033[2J <script>alert(1)</script>\n" RIGHT, compile_error, compiler_says_it},
    {"escapes", "in an error of the assembler", "asm(\".error \\\"\\\\033[2J<script>\\\"\");\n" RIGHT, compile_error,
     compiler_says_it},
    {"escapes", "in the source", "int rigid = \"<script>alert(1)</script>\033[2J\";\n" RIGHT, compile_error,
     compiler_says_it},
    {"escapes", "in a name of the linker",
     "extern \"C\" double f(double) asm(\"<script>\");\ndouble rigid::twice(double x) { return f(x); }\n",
     compile_error, compiler_says_it},
};

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
  for (const Attack& attack : texts_of_attacks) {
    INFO(attack.kind << ": " << attack.what);
    const std::string& text = attack.code;
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
    CHECK_MESSAGE(!is_hostile(page), page);
    const std::string said =
        compilation.message + compilation.details + printed(observation) + judge(reference, observation).message;
    CHECK_MESSAGE((!has(said, "\033") && !has(said, "\u202e")), said);
  }
}

TEST_CASE("a name that is an option of the compiler is a name") {
  restore_canary();
  for (const Name& each : names) {
    INFO(std::string(each.what));
    CHECK_FALSE(compiles(compile_unhindered(RIGHT, each.name)));
    const auto begun = std::chrono::steady_clock::now();
    const Submission submission{each.name, each.name, RIGHT};
    const Compilation compilation = compile({submission, "twice", signature("twice")}, toolchain(), shared_cache());
    REQUIRE(compilation.executable.has_value());
    const ExerciseReference reference = reference_at(7);
    expect({"names", each.what, "", passed}, reference,
           ExerciseRunner(*compilation.executable, short_limits()).observe(plan_calls(reference.cases), {}), begun);
  }
}

}  // namespace workbook::testing
