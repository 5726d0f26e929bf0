// The commands besides check, and the ways to call them wrongly.
#include "checker/course/progress.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

void solve(const CourseCopy& course, const std::string& name) {
  fs::copy_file(course.solution(name), course.exercise(name), fs::copy_options::overwrite_existing);
}

}  // namespace

TEST_CASE("without a command the checker says what is next, and remembers what passed") {
  const CourseCopy course;
  CHECK(has(course.run("").out, "Next: spring_energy"));
  solve(course, "spring_energy");
  CHECK(course.run("check spring_energy").status == 0);
  CHECK(has(course.run("").out, "Next: spring_force"));
  CHECK(has(course.run("list").out, "✓ spring_energy"));
  course.answer_energy("return 0;");
  CHECK(has(course.run("list").out, "changed since it passed"));
  solve(course, "spring_energy");
  solve(course, "spring_force");
  const Outcome all = course.run("check");
  CHECK(all.status == 0);
  CHECK(has(all.out, "2 of 2 passed."));
  CHECK(has(course.run("").out, "All 2 exercises pass"));
}

TEST_CASE("a lecture is known by its name, its number and its topic") {
  const CourseCopy course;
  for (const char* name : {"01_springs", "01", "springs"}) {
    CAPTURE(name);
    CHECK(course.run(std::string("check --json ") + name).json().at("results").size() == 2);
  }
}

TEST_CASE("an unknown name gets a proposal") {
  const CourseCopy course;
  for (const char* command : {"check spring_enrgy", "hint spring_enrgy", "plot spring_enrgy", "reset spring_enrgy"}) {
    CAPTURE(command);
    const Outcome outcome = course.run(command);
    CHECK(outcome.status == 2);
    CHECK_MESSAGE(has(outcome.err, "Did you mean 'spring_energy'?"), outcome.err);
  }
  CHECK(has(course.run("check quaternion").err, "There is no exercise or lecture 'quaternion'."));
}

TEST_CASE("commands are proposed as the program was typed") {
  const CourseCopy course;
  const Outcome outcome = course.run("hint quaternion", "WORKBOOK_PROGRAM=./checker/run");
  CHECK(outcome.err == "There is no exercise 'quaternion'. `./checker/run list` shows all names.\n");
}

TEST_CASE("wrong usage has a status of its own") {
  const CourseCopy course;
  CHECK(course.run("frobnicate").status == 2);
  CHECK(course.run("check --no-such-option").status == 2);
  CHECK(course.run("check --seed many").status == 2);
  const Outcome two_for_one = course.run("check --file x.cpp");
  CHECK(two_for_one.status == 2);
  CHECK(has(two_for_one.err, "--file needs the one exercise"));
  CHECK(course.run("plot").status == 2);
  CHECK(course.run("--help").status == 0);
  CHECK(has(course.run("--help").out, "self-check"));
}

TEST_CASE("hints come one at a time, and the last one stays") {
  const CourseCopy course;
  CHECK(has(course.run("hint spring_energy").out, "Hint 1 of 3\n  Read."));
  CHECK(has(course.run("hint spring_energy").out, "Hint 2 of 3\n  Think."));
  CHECK(has(course.run("hint spring_energy").out, "Hint 3 of 3\n  Write."));
  CHECK(has(course.run("hint spring_energy").out, "That was the last hint."));
  CHECK(has(course.run("hint spring_force --all").out, "Hint 1 of 3"));
  fs::remove(course.root() / "lectures/01_springs/exercises/spring_force.hints.md");
  const Outcome missing = course.run("hint spring_force");
  CHECK(missing.status == 3);
  CHECK(has(missing.err, "the hints are missing"));
}

TEST_CASE("reset puts the stub back and keeps what was there") {
  const CourseCopy course;
  const std::string stub = read(course.exercise("spring_energy"));
  course.answer_energy("return 42;");
  const std::string answer = read(course.exercise("spring_energy"));
  const Outcome outcome = course.run("reset spring_energy");
  CHECK(outcome.status == 0);
  CHECK(read(course.exercise("spring_energy")) == stub);
  CHECK(read(course.root() / ".workbook/kept/spring_energy.1.cpp") == answer);
  CHECK(has(outcome.out, "Your version is kept as"));
}

TEST_CASE("plots are written as SVG and PNG, with the misconception by name") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  const Outcome outcome = course.run("plot spring_energy --out pictures");
  CHECK(outcome.status == 0);
  const std::string svg = read(course.root() / "pictures/spring_energy.svg");
  CHECK(has(svg, "E yours"));
  CHECK(has(svg, "E reference"));
  CHECK(has(svg, "no half"));
  CHECK(has(svg, "x (m)"));
  CHECK(read(course.root() / "pictures/spring_energy.png").substr(1, 3) == "PNG");
  CHECK(has(course.run("check spring_energy --plot").out, "spring_energy.svg"));
}

TEST_CASE("a plot without a function shows the reference and says so") {
  const CourseCopy course;
  const Outcome outcome = course.run("plot spring_energy --out pictures");
  CHECK(outcome.status == 1);
  CHECK(has(outcome.out, "only the reference is drawn"));
  CHECK(fs::exists(course.root() / "pictures/spring_energy.svg"));
}

TEST_CASE("without gnuplot the check works and says what is missing") {
  const CourseCopy course;
  solve(course, "spring_energy");
  const Outcome outcome = course.run("check spring_energy --plot --json", "PATH=/nowhere");
  CHECK(outcome.status == 0);
  CHECK(outcome.json().at("results").at(0).at("verdict") == "passed");
  CHECK(has(outcome.err, "gnuplot is not installed"));
  CHECK(has(course.run("doctor", "PATH=/nowhere").out, "checks work, plots do not"));
}

TEST_CASE("a folder that cannot be written is named") {
  const CourseCopy course;
  solve(course, "spring_energy");
  write(course.root() / "pictures", "a file where the folder should be");
  const Outcome plot = course.run("plot spring_energy --out pictures");
  CHECK(plot.status == 3);
  CHECK(has(plot.err, "The plot could not be written to pictures"));

  write(course.root() / ".workbook", "a file where the folder should be");
  const Outcome check = course.run("check spring_energy");
  CHECK(check.status == 0);
  CHECK(has(check.err, "Your progress could not be saved"));
}

TEST_CASE("two checkers at once each keep what the other writes down") {
  const CourseCopy course;
  const fs::path file = course.root() / ".workbook/progress.json";
  workbook::Progress check(file);
  workbook::Progress hint(file);
  hint.remember_hints("spring_energy", 2);
  check.remember("spring_energy", {"passed", "its fingerprint"});
  hint.remember_hints("spring_force", 1);
  const workbook::Progress both(file);
  CHECK(both.passed("spring_energy", "its fingerprint"));
  CHECK(both.hints_shown("spring_energy") == 2);
  CHECK(both.hints_shown("spring_force") == 1);
}

TEST_CASE("output that is no terminal has no colour codes") {
  const CourseCopy course;
  course.answer_energy("return 0;");
  for (const char* command : {"", "list", "check", "doctor", "hint spring_energy"}) {
    CHECK_FALSE(has(course.run(command).out, "\033["));
  }
}

TEST_CASE("worked examples that cannot be built are trouble of our own, and an unknown lecture gets a proposal") {
  const CourseCopy course;  // it has no build of its own
  const Outcome outcome = course.run("examples springs");
  CHECK(outcome.status == 3);
  CHECK_MESSAGE(has(outcome.err, "The worked examples of 01_springs could not be built."), outcome.err);
  const Outcome unknown = course.run("examples sprigs");
  CHECK(unknown.status == 2);
  CHECK_MESSAGE(has(unknown.err, "Did you mean 'springs'?"), unknown.err);
}
