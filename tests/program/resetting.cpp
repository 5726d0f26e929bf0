// Reset: what was written is kept, a lost file comes back, and a reset that fails loses nothing.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;
namespace fs = std::filesystem;

TEST_CASE("a reset keeps every version, and writes the stub that was shipped") {
  const CourseCopy course;
  const std::string shipped = read(course.exercise("spring_energy"));
  for (const char* name : {"spring_energy.cpp", "spring_energy.cpp.2"}) {
    course.answer_energy(std::string("return 1;  // ") + name);
    const std::string mine = read(course.exercise("spring_energy"));
    CHECK(course.run("reset spring_energy").status == 0);
    CHECK(read(course.root() / ".workbook/kept" / name) == mine);
    CHECK(read(course.exercise("spring_energy")) == shipped);
  }
}

TEST_CASE("a missing file is not started, and reset writes it") {
  const CourseCopy course;
  const std::string shipped = read(course.exercise("spring_energy"));
  fs::remove(course.exercise("spring_energy"));
  const Outcome checked = course.run("check --json");
  CHECK(checked.status == 1);
  CHECK(checked.json().at("results").at(0).at("verdict") == "not_started");
  CHECK(course.run("reset spring_energy").status == 0);
  CHECK(read(course.exercise("spring_energy")) == shipped);
}

TEST_CASE("an exercise is not reset where the student's version cannot be kept") {
  const CourseCopy course;
  course.answer_energy("return 1;");
  const std::string mine = read(course.exercise("spring_energy"));
  write(course.root() / ".workbook", "a file where the folder should be\n");
  const Outcome outcome = course.run("reset spring_energy");
  CHECK(outcome.status == 3);
  CHECK_MESSAGE(has(outcome.err, ".workbook/kept/spring_energy.cpp"), outcome.err);
  CHECK(read(course.exercise("spring_energy")) == mine);
}

TEST_CASE("a stub that cannot be written is named") {
  const CourseCopy course;
  const fs::path folder = course.exercise("spring_energy").parent_path();
  fs::remove_all(folder);
  write(folder, "a file where the folder should be\n");
  const Outcome outcome = course.run("reset spring_energy");
  CHECK(outcome.status == 3);
  CHECK_MESSAGE(has(outcome.err, "exercises/spring_energy.cpp"), outcome.err);
}
