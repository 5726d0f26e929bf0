// Names on the command line that could mean two things.
#include "checker/course/course.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;

TEST_CASE("an exercise that is called like the topic of a lecture is the exercise") {
  const CourseCopy course;
  // The lecture 01_springs becomes 01_spring_force, whose topic is the name of one of its exercises.
  std::filesystem::rename(course.root() / "lectures/01_springs", course.root() / "lectures/01_spring_force");
  replace_in(course.root() / "course.json", "01_springs", "01_spring_force");
  const workbook::Course renamed(course.root() / "course.json");
  REQUIRE(renamed.find("spring_force").size() == 1);
  CHECK(renamed.find("spring_force").front().name() == "spring_force");
  CHECK(renamed.find("01_spring_force").size() == 2);
  CHECK(renamed.find("01").size() == 2);
  CHECK_THROWS_WITH_AS(renamed.find("02"), "There is no exercise or lecture '02'. `checker list` shows all names.",
                       workbook::UnknownName);
}
