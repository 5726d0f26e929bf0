// self-check: every fault that an author can make is found, with the file and the fix.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace workbook::testing;
namespace fs = std::filesystem;

TEST_CASE("every fault of the files of an exercise or a lecture is named with its file and what is needed") {
  CourseCopy().check_story("self_check");
}

TEST_CASE(
    "self-check names lost digits and a record of typical bugs that does not fit, and writes a new one when asked") {
  const CourseCopy course;
  const fs::path record = course.root() / "solutions/01_springs/judging/adequacy.json";
  const std::string before = read(record);
  CHECK(course.run("self-check --prove").status == 0);

  {
    const CourseCopy worse;
    worse.stand_in("reference/rounding_01_springs", R"(printf '0.5\tspring_energy\ta case, the solution\n')");
    const Outcome rounded = worse.run("self-check --prove spring_energy");
    CHECK(rounded.status == 1);
    CHECK_MESSAGE(has(rounded.out, "spring_energy.cpp: rounding takes 0.5 of the tolerance at a case, the solution.\n"),
                  rounded.said());
  }

  write(record, "{}\n");
  const Outcome differs = course.run("self-check --prove spring_energy");
  CHECK(differs.status == 1);
  CHECK_MESSAGE(has(differs.out, "solutions/01_springs/judging/spring_energy.cpp: "), differs.out);
  CHECK(has(differs.out, "self-check --record"));
  CHECK(read(record) == "{}\n");

  CHECK(course.run("self-check --record").status == 0);
  CHECK(read(record) == before);
  write(record, "{\n");
  CHECK_MESSAGE(has(course.run("self-check --prove").said(), "adequacy.json"), "a damaged record is named");
  fs::remove_all(course.root() / "solutions");
  CHECK(course.run("self-check --record").status == 2);
}

TEST_CASE("self-check names the changes of a solution that no case finds, and says why they cannot be tried") {
  const CourseCopy course;
  const Outcome all_found = course.run("self-check --prove 01");
  CHECK_MESSAGE(all_found.status == 0, all_found.said());
  CHECK(has(all_found.out, "01 spring_energy"));

  const std::string of_force = "solutions/01_springs/judging/spring_force.cpp: ";
  replace_in(course.solution("spring_force"), "-k * x", "-k * x * std::cos(1e-30)");
  const Outcome survived = course.run("self-check --prove spring_force");
  CHECK(survived.status == 1);
  CHECK_MESSAGE((has(survived.out, of_force) && has(survived.out, "line 5, another number: ")), survived.out);
  CHECK(!has(survived.out, "spring_energy"));

  replace_in(course.solution("spring_force"), "-k * x", "k * x");
  const Outcome wrong = course.run("self-check --prove 01");
  CHECK(wrong.status == 1);
  CHECK_MESSAGE((has(wrong.out, of_force) && has(wrong.out, "does not pass")), wrong.out);
  CHECK(has(wrong.out, "01 spring_energy"));
  fs::remove_all(course.root() / "solutions");
  CHECK(course.run("self-check --prove").status == 2);
}

TEST_CASE("a new exercise has its heading before what ends the lecture") {
  const CourseCopy course;
  const std::string before = read(course.notes());
  write(course.notes(), before + "\n## Questions {#springs_questions}\n\n\\slides\n\\endslides\n");
  const Outcome made = course.run("new exercise spring_power --lecture 01 --signature 'double spring_power(double k)'");
  REQUIRE_MESSAGE(made.status == 0, made.said());
  CHECK(read(course.notes()) == before +
                                    "\n### Spring power {#springs_spring_power}\n\nTODO\n\n## Questions "
                                    "{#springs_questions}\n\n\\slides\n\\endslides\n");
}
