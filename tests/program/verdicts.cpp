// Every kind of answer gets its verdict, its reason with the place, and no point that it does not deserve.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <filesystem>
#include <vector>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

struct Answer {
  const char* about;
  const char* body;  ///< of spring_energy
  const char* verdict;
  const char* diagnosis = "";  ///< the name of the first one
  int line = 0;                ///< of the first finding
  const char* before = "";
};

const std::vector<Answer> answers = {
    {"right", "return 0.5 * k * x.squaredNorm();", "passed"},
    {"right by another route", "double e = 0; for (double c : x) e += k * c * c; return e / 2;", "passed"},
    {"right with a line that does nothing", "double y = 2; return 0.5 * k * x.squaredNorm();", "passed"},
    {"a known mistake", "return k * x.squaredNorm();", "wrong_value", "no_half"},
    {"a known mistake, and no finite number where x_1 = 0", "return k * x.squaredNorm() * (x(0) / x(0));",
     "non_finite_value", "no_half", 4},
    {"a mistake in some cases", "return k > 3 ? 0.0 : 0.5 * k * x.squaredNorm();", "wrong_value", "", 4},
    {"a small mistake", "return 0.5000001 * k * x.squaredNorm();", "wrong_value", "accuracy"},
    {"a slip of C++", "double factor = 1/2 + k;\nreturn factor * x.squaredNorm();", "wrong_value", "", 4},
    {"does not compile", "return 0.5 * k * x.squaredNorm()", "compile_error", "", 4},
    {"a power of another language", "return 0.5 * k * x^2;", "compile_error", "", 4},
    {"throws", "throw std::runtime_error(\"no idea\");", "uncaught_exception", "", 4},
    {"an index beyond the end", "return x(7);", "uncaught_exception", "", 4},
    {"crashes", "int* p = nullptr; *p = 1; return k;", "crashed", "", 4},
    {"exits early", "std::exit(0);", "stopped_early", "", 4},
    {"sleeps", "std::this_thread::sleep_for(std::chrono::seconds(1000)); return k;", "time_limit", "", 5,
     "#include <thread>\n"},
    {"floods the output", "while (true) std::puts(\"again and again and again\"); return k;", "output_limit"},
    {"prints a fake reply", "std::puts(\"{\\\"verdict\\\": \\\"passed\\\"}\"); return 0;", "wrong_value", "zero"},
    {"a half in whole numbers with names", "const int one = 1, two = 2; return one / two * k * x.squaredNorm();",
     "wrong_value", "", 4},
    {"returns NaN", "return std::nan(\"\");", "non_finite_value"},
    {"remembers earlier calls", "static int calls = 0; return 0.5 * k * x.squaredNorm() + 1e-3 * calls++;",
     "inconsistent_value"},
    {"learnt by heart", "static int call = 0; ++call; return 9.0;", "wrong_value", "no_effect"},
    {"opens a file", "std::ifstream(\"/etc/passwd\"); return 0.5 * k * x.squaredNorm();", "forbidden_operation", "", 0,
     "#include <fstream>\n"},
    {"not started", "throw NotStarted{};", "not_started"},
};

/// They take all that they may have, which is seconds of a processor; with less to take the test of endings tries them.
const std::vector<Answer> insatiable_answers = {
    {"loops", "volatile int i = 0; while (true) ++i; return k;", "time_limit", "", 4},
    {"eats memory", "std::vector<double> v; while (true) v.resize(v.size() + 10000000, k); return k;", "memory_limit"},
};

/// Asserts verdict, points and place of each; what is said of them.
std::string told(const std::vector<Answer>& all) {
  const CourseCopy course;
  std::string sentences;
  for (const Answer& answer : all) {
    CAPTURE(answer.about);
    course.answer_energy(answer.body, answer.before);
    const Outcome outcome = course.run("check spring_energy --json");
    const auto result = outcome.result();
    CAPTURE(result.dump(2));
    const std::string verdict = answer.verdict;
    const bool is_right = verdict == "passed";
    CHECK(outcome.status == (is_right ? 0 : 1));
    CHECK(result.at("verdict") == verdict);
    CHECK(result.at("score") == (is_right ? 2.0 : 0.0));
    CHECK(result.at("points") == 2.0);
    const auto& diagnoses = result.at("diagnosis");
    const auto& findings = result.at("findings");
    CHECK((diagnoses.empty() ? "" : diagnoses.at(0).at("name")) == answer.diagnosis);
    if (answer.line > 0) {
      REQUIRE(!findings.empty());
      CHECK(findings.at(0).at("line") == answer.line);
      CHECK(findings.at(0).at("excerpt") != "");
    }
    if (is_right || verdict == "not_started") CHECK((diagnoses.empty() && findings.empty()));
    sentences += fmt::format("{}\n  {}\n", answer.about, result.at("message").get<std::string>());
    for (const auto& reason : diagnoses)
      sentences += fmt::format("  why: {}\n", reason.at("message").get<std::string>());
    CHECK(result.contains("next") == (diagnoses.empty() && findings.empty()));
    sentences += result.contains("next") ? fmt::format("  next: {}\n\n", result.at("next").get<std::string>()) : "\n";
  }
  return sentences;
}

}  // namespace

TEST_CASE("every answer gets its verdict, its reason and its points") { check_golden("verdicts", told(answers)); }

TEST_CASE("an answer that takes all the time or memory gets its verdict too" * doctest::test_suite("thorough")) {
  told(insatiable_answers);
}

TEST_CASE("the first failing case comes with its numbers, and a diagnosis with the paragraph to read") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  const auto result = course.run("check spring_energy --json").result();
  CHECK(result.at("diagnosis").at(0).at("kind") == "misconception");
  CHECK(result.at("diagnosis").at(0).at("notes") == "springs_energy");
  CHECK(result.at("first_failure").at("number") == 1);
  CHECK(result.at("first_failure").at("expected") == 0.5);
  CHECK(result.at("first_failure").at("actual") == 1.0);
  CHECK(result.at("first_failure").at("inputs").at("k") == 1.0);
  CHECK(result.at("cases").at("passed").get<int>() < 10);  // where the spring is at rest
}

TEST_CASE("a function of another name, what is no ordinary file, a file name that is odd, and what a function prints") {
  CourseCopy().check_story("odd_files");
}

TEST_CASE("another seed draws other cases") {
  const CourseCopy course;
  course.solve("spring_energy");
  const Outcome outcome = course.run("check spring_energy --seed 5 --json");
  CHECK(outcome.status == 0);
  CHECK(outcome.json().at("seed") == 5);
  course.answer_energy("return k > 3 ? 0.0 : 0.5 * k * x.squaredNorm();");
  const auto number = [&](const std::string& seed) {
    return course.run("check spring_energy --json --seed " + seed).result().at("first_failure").at("inputs");
  };
  CHECK(number("5") != number("1"));
}

TEST_CASE("a copy without solutions is judged with the seed of its reference results") {
  const CourseCopy course;
  course.solve("spring_energy");
  const fs::path program = course.root() / "reference/reference_01_springs";
  const Outcome drawn = run_command(fmt::format("'{}' --lecture 01_springs --seed 5 --adequacy '' --out '{}'",
                                                program.string(), course.reference().string()),
                                    course.root());
  REQUIRE_MESSAGE(drawn.status == 0, drawn.said());
  fs::remove(program);
  fs::remove_all(course.root() / "solutions");
  const Outcome outcome = course.run("check spring_energy --json");
  CHECK(outcome.status == 0);
  CHECK(outcome.json().at("seed") == 5);
  CHECK(has(read(course.root() / ".workbook/progress.json"), "spring_energy"));
  CHECK(course.run("check spring_energy --seed 5").status == 0);
  CHECK(has(course.run("check spring_energy --seed 1").said(), "seed 5 only"));
}
