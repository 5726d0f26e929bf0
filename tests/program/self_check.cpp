// self-check: every fault that an author can make is found, with the file and the cure.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

void require_fault(const CourseCopy& course, const std::string& file, const std::string& cure) {
  const Outcome outcome = course.run("self-check --seeds 1");
  CHECK(outcome.status == 1);
  CHECK_MESSAGE(has(outcome.out, file), outcome.out);
  CHECK_MESSAGE(has(outcome.out, cure), outcome.out);
}

}  // namespace

TEST_CASE("self-check finds nothing in a course that is in order") {
  const CourseCopy course;
  const Outcome outcome = course.run("self-check --seeds 3");
  CHECK_MESSAGE(outcome.status == 0, (outcome.out + outcome.err));
  CHECK(has(outcome.out, "In order: 1 lecture, 2 exercises, 6 right routes, 6 wrong answers, 3 seeds."));
}

TEST_CASE("self-check finds a deleted hint") {
  const CourseCopy course;
  SUBCASE("the file") {
    fs::remove(course.root() / "lectures/01_springs/exercises/spring_energy.hints.md");
    require_fault(course, "lectures/01_springs/exercises/spring_energy.hints.md", "write it, or take it off the card");
  }
  SUBCASE("one of three") {
    write(course.root() / "lectures/01_springs/exercises/spring_energy.hints.md", "Read.\n\n---\n\nThink.\n");
    require_fault(course, "lectures/01_springs/exercises/spring_energy.hints.md", "2 hints instead of 3");
  }
}

TEST_CASE("self-check finds a stub that is solved") {
  const CourseCopy course;
  fs::copy_file(course.solution("spring_energy"), course.exercise("spring_energy"),
                fs::copy_options::overwrite_existing);
  require_fault(course, "lectures/01_springs/exercises/spring_energy.cpp",
                "`checker reset spring_energy` puts it back");
}

TEST_CASE("self-check finds a solution that is wrong") {
  const CourseCopy course;
  replace_in(course.solution("spring_force"), "-k * x", "k * x");
  require_fault(course, "solutions/01_springs/spring_force.cpp", "Mend the solution or its judging.");
}

TEST_CASE("self-check finds a misconception that is no mistake") {
  const CourseCopy course;
  auto document = nlohmann::json::parse(read(course.reference()));
  auto& exercise = document["exercises"][0];
  exercise["misconceptions"][0]["outputs"] = exercise["routes"][0]["outputs"];
  write(course.reference(), document.dump());
  require_fault(course, "solutions/01_springs/judging.cpp: spring_energy", "no_half");
}

TEST_CASE("self-check finds an exercise on the card that does not exist") {
  const CourseCopy course;
  replace_in(
      course.card(), "\"exercises\": [",
      "\"exercises\": [ {\"name\": \"ghost\", \"points\": 1, \"notes\": \"springs_energy\", \"task\": \"None.\"},");
  require_fault(course, "lectures/01_springs/exercises/ghost.cpp", "write it, or take it off the card");
  require_fault(course, "01_springs.json", "'ghost' is missing, though the card of 01_springs lists it");
}

TEST_CASE("self-check finds a stray file") {
  const CourseCopy course;
  write(course.root() / "lectures/01_springs/exercises/spring_old.cpp", "// forgotten\n");
  require_fault(course, "lectures/01_springs/exercises/spring_old.cpp",
                "add its exercise to the card, or move the file away");
}

TEST_CASE("self-check finds a snippet without its mark") {
  const CourseCopy course;
  replace_in(course.root() / "lectures/01_springs/worked_examples.cpp", "//! [energy]", "//");
  require_fault(course, "lectures/01_springs/notes.md: quotes 'energy'", "put them around the example");
}

TEST_CASE("self-check finds a diagnosis that points nowhere") {
  const CourseCopy course;
  replace_in(course.notes(), "{#springs_force}", "");
  require_fault(course, "lectures/01_springs/notes.md: no paragraph has the anchor 'springs_force'", "to a heading");
}

TEST_CASE("self-check finds a fact that no paragraph teaches") {
  const CourseCopy course;
  replace_in(course.card(), "\"facts\": [1]", "\"facts\": [1, 2]");
  require_fault(course, "lectures/01_springs/notes.md", "<!-- fact 2 -->");
}

TEST_CASE("self-check finds a contract that declares something else") {
  const CourseCopy course;
  replace_in(course.root() / "include/rigid/springs.hpp", "spring_energy(double k", "spring_energy(double stiffness");
  require_fault(course, "include/rigid/springs.hpp", "make contract and judging agree");
}
