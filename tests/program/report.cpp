// The command that writes one student's page.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace workbook::testing;
namespace fs = std::filesystem;

TEST_CASE("a page is about all that was asked, says what could not be judged, and is no progress") {
  CourseCopy().check_story("reporting");
}

TEST_CASE("a student's file that is missing, or is no text, leaves a page all the same") {
  const CourseCopy course;
  fs::remove(course.exercise("spring_energy"));
  write(course.exercise("spring_force"), std::string("\xff\xfe\0\x01 int main", 13));
  CHECK(course.run("report --html page.html", without_programs).status == 0);
  const std::string page = read(course.root() / "page.html");
  CHECK(has(page, "rejected file"));
  CHECK(has(page, "gnuplot"));
  CHECK_FALSE(has(page, "<img"));
  CHECK_FALSE(has(page, std::string(1, '\0')));
}
