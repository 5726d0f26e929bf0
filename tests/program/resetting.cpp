// A reset that fails loses nothing, and says what is in the way.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;
namespace fs = std::filesystem;

TEST_CASE("an exercise is not reset where the student's version cannot be kept") {
  const CourseCopy course;
  course.answer_energy("return 1;");
  const std::string mine = read(course.exercise("spring_energy"));
  write(course.root() / ".workbook", "a file where the folder should be\n");
  const Outcome outcome = course.run("reset spring_energy");
  CHECK(outcome.status == 3);
  CHECK_MESSAGE(has(outcome.err, "spring_energy was not reset, because your version could not be kept as "),
                outcome.err);
  CHECK(read(course.exercise("spring_energy")) == mine);
}

TEST_CASE("an exercise is not reset where the stub cannot be written") {
  const CourseCopy course;
  course.answer_energy("return 1;");
  const std::string mine = read(course.exercise("spring_energy"));
  fs::create_directories(course.exercise("spring_energy").string() + ".new");
  const Outcome outcome = course.run("reset spring_energy");
  CHECK(outcome.status == 3);
  CHECK_MESSAGE(has(outcome.err, "spring_energy.cpp.new cannot be written; make its folder writable."), outcome.err);
  CHECK(read(course.exercise("spring_energy")) == mine);
}
