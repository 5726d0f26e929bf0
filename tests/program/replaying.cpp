// Seeing exactly one failure again, and no more of a report than is wanted.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <regex>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

/// What the report says to type, without the program's name.
std::string command_behind(const std::string& label, const std::string& report) {
  const std::regex line(label + " +checker ([^\n]+)");
  std::smatch found;
  return std::regex_search(report, found, line) ? found[1].str() : "";
}

std::string paragraph_from(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  return text.substr(begin, text.find(to, begin) - begin);
}

}  // namespace

TEST_CASE("the report says what to type to see the same failure again, and it is the same") {
  const CourseCopy course;
  course.answer_energy("return x.squaredNorm() * k * (k > 1.5 ? 1.0 : 0.5);");
  for (const char* seed : {"", " --seed 5"}) {
    const Outcome first = course.run(std::string("check spring_energy") + seed);
    const std::string again = command_behind("Again", first.out);
    REQUIRE_MESSAGE(!again.empty(), first.out);
    CHECK(has(again, seed));
    const Outcome second = course.run(again);
    CHECK(second.status == first.status);
    CHECK(paragraph_from(first.out, "Case “", "Why") == paragraph_from(second.out, "Case “", "Why"));
  }
}

TEST_CASE("a case that is asked for by name is shown even if it passes") {
  const CourseCopy course;
  fs::copy_file(course.solution("spring_energy"), course.exercise("spring_energy"),
                fs::copy_options::overwrite_existing);
  const std::string name = nlohmann::json::parse(read(course.reference()))["exercises"][0]["cases"][1]["name"];
  const Outcome outcome = course.run("check spring_energy --case '" + name + "'");
  CHECK(outcome.status == 0);
  CHECK(has(outcome.out, "Case “" + name + "”"));
  CHECK(has(outcome.out, "Inputs"));
}

TEST_CASE("an unknown case gets a proposal, or the list of cases") {
  const CourseCopy course;
  const std::string name = nlohmann::json::parse(read(course.reference()))["exercises"][0]["cases"][0]["name"];
  const Outcome near = course.run("check spring_energy --case '" + name.substr(1) + "'");
  CHECK(near.status == 2);
  CHECK_MESSAGE(has(near.err, "Did you mean '" + name + "'?"), near.err);
  const Outcome far = course.run("check spring_energy --case quaternions");
  CHECK(far.status == 2);
  CHECK_MESSAGE(has(far.err, "Its cases are: " + name), far.err);
  const Outcome many = course.run("check --case one");
  CHECK(many.status == 2);
  CHECK(has(many.err, "--case needs the one exercise that the case belongs to"));
}

TEST_CASE("what is not started can be left out") {
  const CourseCopy course;
  const Outcome nothing = course.run("check --started");
  CHECK(nothing.status == 0);
  CHECK(has(nothing.out, "No exercise is started, so there was nothing to check."));
  fs::copy_file(course.solution("spring_energy"), course.exercise("spring_energy"),
                fs::copy_options::overwrite_existing);
  const Outcome one = course.run("check --started");
  CHECK(one.status == 0);
  CHECK(has(one.out, "spring_energy"));
  CHECK(!has(one.out, "spring_force"));
  CHECK(course.run("check --started --json").json().at("results").size() == 1);
}

TEST_CASE("all that the compiler says is one option away") {
  const CourseCopy course;
  course.answer_energy("return first_mistake + second_mistake;");
  const Outcome brief = course.run("check spring_energy");
  CHECK(!has(brief.out, "second_mistake’ was not declared"));
  CHECK(command_behind("More", brief.out) == "check spring_energy --full");
  const Outcome full = course.run("check spring_energy --full");
  CHECK(has(full.out, "All that the compiler says:"));
  CHECK(has(full.out, "first_mistake"));
  CHECK(has(full.out, "second_mistake"));
}

TEST_CASE("commands in reports are written as the program was started") {
  const CourseCopy course;
  course.answer_energy("return 0;");
  CHECK(
      has(course.run("check spring_energy", "WORKBOOK_PROGRAM=./checker/run").out, "./checker/run hint spring_energy"));
}

TEST_CASE("a wrong value is drawn unasked") {
  const CourseCopy course;
  course.answer_energy("return 0;");
  const Outcome outcome = course.run("check spring_energy");
  CHECK(has(outcome.out, "spring_energy.svg"));
  const Outcome without_gnuplot = course.run("check spring_energy", "PATH=/nowhere");
  CHECK(has(without_gnuplot.out, "Plot   checker plot spring_energy"));
}
