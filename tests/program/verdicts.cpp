// The checker as a program: every kind of answer gets its verdict, its sentence, and no point it does not deserve.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <sys/stat.h>

#include <filesystem>
#include <vector>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

struct Answer {
  const char* about;
  const char* body;  ///< of spring_energy
  const char* verdict;
  const char* sentence;  ///< part of the message
  const char* before = "";
};

const std::vector<Answer> answers = {
    {"right", "return 0.5 * k * x.squaredNorm();", "passed", "agree with the reference"},
    {"right by another route", "double e = 0; for (double c : x) e += k * c * c; return e / 2;", "passed",
     "agree with the reference"},
    {"wrong", "return k * x.squaredNorm();", "wrong_value", "The value is wrong at 7 of 7 cases"},
    {"right at some cases only", "return k > 3 ? 0.0 : 0.5 * k * x.squaredNorm();", "wrong_value",
     "The value is wrong"},
    {"does not compile", "return 0.5 * k * x.squaredNorm()", "compile_error", "line 4"},
    {"throws", "throw std::runtime_error(\"no idea\");", "uncaught_exception", "no idea"},
    {"index beyond the end", "return x(7);", "uncaught_exception", "exception"},
    {"crashes", "int* p = nullptr; *p = 1; return k;", "crashed", "signal 11"},
    {"exits with 0 early", "std::exit(0);", "stopped_early", "exit status 0"},
    {"loops", "volatile int i = 0; while (true) ++i; return k;", "time_limit", "did not return in time"},
    {"eats memory", "std::vector<double> v; while (true) v.resize(v.size() + 10000000, k); return k;", "memory_limit",
     "more memory"},
    {"floods the output", "while (true) std::puts(\"again and again and again\"); return k;", "output_limit",
     "printed more than"},
    {"prints a fake reply", "std::puts(\"{\\\"verdict\\\": \\\"passed\\\"}\"); return 0;", "wrong_value",
     "The value is wrong"},
    {"returns NaN", "return std::nan(\"\");", "non_finite_value", "not a number"},
    {"random answers",
     "return 0.5 * k * x.squaredNorm() + 1e-3 * (std::chrono::steady_clock::now().time_since_epoch().count() % 1000);",
     "inconsistent_value", "The same input gave two results", "#include <chrono>\n"},
    {"opens a file", "std::ifstream(\"/etc/passwd\"); return 0.5 * k * x.squaredNorm();", "forbidden_operation",
     "no exercise needs", "#include <fstream>\n"},
    {"not started", "throw NotStarted{};", "not_started", "not started"},
};

}  // namespace

TEST_CASE("every answer gets its verdict, its sentence and its points") {
  const CourseCopy course;
  for (const Answer& answer : answers) {
    CAPTURE(answer.about);
    course.answer_energy(answer.body, answer.before);
    const Outcome outcome = course.run("check spring_energy --json");
    const auto document = outcome.json();
    const auto& result = document.at("results").at(0);
    const bool right = std::string(answer.verdict) == "passed";
    CHECK(outcome.status == (right ? 0 : 1));
    CHECK(result.at("verdict") == answer.verdict);
    CHECK(result.at("score") == (right ? 2.0 : 0.0));
    CHECK(result.at("points") == 2.0);
    const std::string message = result.at("message");
    CHECK_MESSAGE(has(message, answer.sentence), message);
    if (right) CHECK(result.at("diagnosis").empty());
  }
}

TEST_CASE("a sleeping answer ends at its time limit") {
  const CourseCopy course;
  course.answer_energy("std::this_thread::sleep_for(std::chrono::seconds(1000)); return k;", "#include <thread>\n");
  const auto result = course.run("check spring_energy --json").json().at("results").at(0);
  CHECK(result.at("verdict") == "time_limit");
  CHECK(result.at("score") == 0.0);
}

TEST_CASE("a known mistake is named, with the paragraph to read") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  const auto result = course.run("check spring_energy --json").json().at("results").at(0);
  REQUIRE(result.at("diagnosis").size() == 1);
  CHECK(result.at("diagnosis").at(0).at("kind") == "misconception");
  CHECK(result.at("diagnosis").at(0).at("name") == "no_half");
  CHECK(result.at("diagnosis").at(0).at("notes") == "springs_energy");
  CHECK(result.at("first_failure").at("expected") == 9.0);
  CHECK(result.at("first_failure").at("actual") == 18.0);
  CHECK(result.at("first_failure").at("inputs").at("k") == 2.0);

  const std::string screen = course.run("check spring_energy").out;
  CHECK(has(screen, "The factor ½ is missing."));
  CHECK(has(screen, "notes.md, paragraph springs_energy"));
}

TEST_CASE("a function that is not there is missing, and the sentence says what the file defines") {
  const CourseCopy course;
  write(
      course.exercise("spring_energy"),
      "#include <rigid/springs.hpp>\nnamespace rigid { double spring_enrgy(double, const Vector3d&) { return 1; } }\n");
  const auto result = course.run("check spring_energy --json").json().at("results").at(0);
  CHECK(result.at("verdict") == "missing_function");
  const std::string message = result.at("message");
  CHECK_MESSAGE(has(message, "does not define `rigid::spring_energy(double, const Vector3d&)`"), message);
  CHECK_MESSAGE(has(message, "spring_enrgy"), message);
}

TEST_CASE("a compiler error is shown with the line, a caret and the name of the mistake") {
  const CourseCopy course;
  course.answer_energy("  return 0.5 * k * x^2;");
  const std::string screen = course.run("check spring_energy", "NO_COLOR=1").out;
  CHECK_MESSAGE(has(screen, "Your file does not compile: the first error is in line 4."), screen);
  CHECK_MESSAGE(has(screen, "Line 4: ^ is not a power in C++ (it combines the bits of whole numbers);"), screen);
  CHECK_MESSAGE(has(screen, "return 0.5 * k * x^2;\n"), screen);
  CHECK_MESSAGE(has(screen, "^\n"), screen);

  const auto findings = course.run("check spring_energy --json").json().at("results").at(0).at("findings");
  REQUIRE(findings.size() == 1);
  CHECK(findings.at(0).at("line") == 4);
}

TEST_CASE("a failure that the text explains is shown with its line, and the verdict stays what it was") {
  const CourseCopy course;
  const auto result = [&] { return course.run("check spring_energy --json").json().at("results").at(0); };

  // A diagnosis says why; the text alone is looked at.
  course.answer_energy("  double y = 2;\n  double factor = 1/2 + k;\n  return factor * x.squaredNorm();");
  CHECK(result().at("verdict") == "wrong_value");
  CHECK_FALSE(result().at("diagnosis").empty());
  REQUIRE(result().at("findings").size() == 1);
  CHECK(has(result().at("findings").at(0).at("message"), "`1/2` divides whole numbers and gives 0"));

  // No diagnosis: the compiler is asked as well.
  course.answer_energy("  double y = 2;\n  return k > 1e9 ? x(7) : std::nan(\"\") + 1/2;");
  CHECK(result().at("verdict") == "non_finite_value");
  CHECK(result().at("diagnosis").empty());
  REQUIRE(result().at("findings").size() == 2);
  CHECK(has(result().at("findings").at(0).at("message"), "`y` is declared, but its value is never used."));
  CHECK(has(result().at("findings").at(1).at("message"), "`1/2` divides whole numbers and gives 0"));

  course.answer_energy("  double y = 2;\n  return 0.5 * k * x.squaredNorm();");
  CHECK(result().at("verdict") == "passed");
  CHECK(result().at("findings").empty());

  course.answer_energy("throw NotStarted{};");
  CHECK(result().at("verdict") == "not_started");
  CHECK(result().at("findings").empty());
}

TEST_CASE("what is no ordinary file is rejected at once") {
  const CourseCopy course;
  const fs::path file = course.exercise("spring_energy");
  const auto verdict = [&] { return course.run("check spring_energy --json").json().at("results").at(0); };

  SUBCASE("a directory") {
    fs::remove(file);
    fs::create_directory(file);
    CHECK(has(verdict().at("message"), "folder"));
  }
  SUBCASE("a FIFO") {
    fs::remove(file);
    REQUIRE(mkfifo(file.c_str(), 0600) == 0);
    CHECK(has(verdict().at("message"), "is not an ordinary file"));
  }
  SUBCASE("a file of 100 MB") {
    fs::resize_file(file, 100'000'000);
    CHECK(has(verdict().at("message"), "large"));
  }
  SUBCASE("no file") {
    fs::remove(file);
    CHECK(has(verdict().at("message"), "does not exist"));
  }
  CHECK(verdict().at("verdict") == "rejected_file");
  CHECK(verdict().at("score") == 0.0);
}

TEST_CASE("a file name with spaces and a leading dash is a file like any other") {
  const CourseCopy course;
  fs::copy_file(course.solution("spring_energy"), course.root() / "-my answer.cpp");
  const Outcome outcome = course.run("check spring_energy --json --file='-my answer.cpp'");
  CHECK(outcome.status == 0);
  CHECK(outcome.json().at("results").at(0).at("verdict") == "passed");
}

TEST_CASE("an answer learnt by heart from one seed fails another") {
  const CourseCopy course;
  course.answer_energy("static int call = 0; ++call; return 9.0;");
  CHECK(course.run("check spring_energy --seed 5").status == 1);
  fs::copy_file(course.solution("spring_energy"), course.exercise("spring_energy"),
                fs::copy_options::overwrite_existing);
  const Outcome outcome = course.run("check spring_energy --seed 5 --json");
  CHECK(outcome.status == 0);
  CHECK(outcome.json().at("seed") == 5);
}
