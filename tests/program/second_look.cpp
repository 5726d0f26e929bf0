// What the student sees of a failure: the line, the sizes, and what the function printed.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;

TEST_CASE("a failure is shown with the line that caused it, and costs no more than before") {
  const CourseCopy course;
  course.answer_energy("return x(7);");
  const auto result = course.run("check spring_energy --json").json().at("results").at(0);
  CHECK(result.at("verdict") == "uncaught_exception");
  CHECK(result.at("score") == 0.0);
  REQUIRE(result.at("findings").size() >= 1);  // where it happened comes first
  CHECK(result.at("findings").at(0).at("line") == 4);
  CHECK(has(result.at("findings").at(0).at("excerpt"), "return x(7);"));
  CHECK(result.at("findings").at(0).at("message") == "index 7 is outside the vector of size 3 (indices 0 to 2).");
  CHECK(
      has(course.run("check spring_energy").out, "Line 4: index 7 is outside the vector of size 3 (indices 0 to 2)."));
}

TEST_CASE("a right answer is not looked at again") {
  const CourseCopy course;
  course.answer_energy("return 0.5 * k * x.squaredNorm();");
  CHECK(course.run("check spring_energy --json").json().at("results").at(0).at("findings").empty());
}

TEST_CASE("what the function printed is labelled, shortened, and harmless to the terminal") {
  const CourseCopy course;
  course.answer_energy(
      "std::cout << \"\\x1b[2J\\x1b]0;title\\a red\\n\" << std::string(500, 'x') << \"\\n\\ttab\\n\"; std::cerr << "
      "\"to errors\\n\";"
      "for (int i = 0; i < 50; ++i) std::cout << i << \"\\n\"; return k;");
  const std::string screen = course.run("check spring_energy", "COLUMNS=60").out;
  CHECK(has(screen, "Your code printed:\n    ?[2J?]0;title? red\n    " + std::string(55, 'x') + "…\n     tab\n"));
  CHECK(has(screen, "more lines\n"));
  CHECK(screen.find('\x1b') == std::string::npos);
  CHECK(screen.find('\a') == std::string::npos);
}

TEST_CASE("a line of many thousand letters is cut too") {
  const CourseCopy course;
  course.answer_energy("std::cout << std::string(60000, 'x'); return k;");
  const std::string screen = course.run("check spring_energy", "COLUMNS=80").out;
  CHECK(has(screen, "    " + std::string(75, 'x') + "…\n"));
  CHECK_FALSE(has(screen, std::string(77, 'x')));
}
