// Every kind of answer gets its verdict, its reason with the place, and no point that it does not deserve.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;

TEST_CASE("every answer gets its verdict, its reason and its points, and the first failing case with its numbers") {
  CourseCopy().check_story("verdicts");
}

// They take all that they may have, which is seconds of a processor; with less to take the test of endings tries them.
TEST_CASE("an answer that takes all the time or memory gets its verdict too" * doctest::test_suite("thorough")) {
  const CourseCopy course;
  for (const auto& [body, verdict] :
       {std::pair{"volatile int i = 0; while (true) ++i; return k;", "time_limit"},
        {"std::vector<double> v; while (true) v.resize(v.size() + 10000000, k); return k;", "memory_limit"}}) {
    course.answer_energy(body);
    const auto result = course.run("check spring_energy --json").result();
    CAPTURE(result.dump(2));
    CHECK(result.at("verdict") == verdict);
    CHECK(result.at("score") == 0.0);
    CHECK(result.at("findings").at(0).at("line") == 4);
  }
}

TEST_CASE("a function of another name, what is no ordinary file, a file name that is odd, and what a function prints") {
  CourseCopy().check_story("odd_files");
}

TEST_CASE("another seed draws other cases; a copy without solutions has those of its reference results and no others") {
  CourseCopy().check_story("seeds");
}
