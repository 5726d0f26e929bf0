// What a description of an exercise foresees is compared with the solution when the reference results are made.
#include "solutions/judging/judging.hpp"

#include <doctest/doctest.h>

using namespace workbook;

namespace {

double half(double x) { return x / 2; }

Exercise<double, double>& described(Lecture& lecture) {
  auto& e = lecture.exercise(&half, {{"x", positive(metre)}}, {"y", metre});
  e.worked("three", 3);
  e.special("one", 1);
  e.random("some", 6, any::uniform(1, 2));
  return e;
}

LectureReference evaluated(void (*judge)(Lecture&)) {
  Lecture lecture;
  lecture.add("half", judge);
  return lecture.evaluate("12_halves", 1, {});
}

}  // namespace

TEST_CASE("a limit names a case and foresees its result") {
  const LectureReference reference =
      evaluated([](Lecture& lecture) { described(lecture).limit("one", 0.5, "Halved."); });
  const ExerciseReference& e = reference.exercises.front();
  REQUIRE(e.limits.size() == 1);
  CHECK(e.limits.front().reason == "Halved.");
  CHECK(e.cases.at(e.limits.front().case_index).name == "one");
  CHECK_THROWS_WITH_AS(evaluated([](Lecture& lecture) { described(lecture).limit("one", 0.51, "Halved."); }),
                       "half, limit 'one': the solution gives 0.5, not 0.51", std::logic_error);
  CHECK_THROWS_WITH_AS(evaluated([](Lecture& lecture) { described(lecture).limit("two", 1, "Halved."); }),
                       "half, limit 'two': there is no such case", std::logic_error);
}

TEST_CASE("real data lie in the domain") {
  CHECK(evaluated([](Lecture& lecture) { described(lecture).measured("a rope", {0.1}, 4); })
            .exercises.front()
            .measured.front()
            .inputs.front()
            .numbers.front() == 4);
  CHECK_THROWS_WITH_AS(evaluated([](Lecture& lecture) { described(lecture).measured("a rope", {0.1}, -4); }),
                       "half: a rope lies outside the domain of the contract", std::logic_error);
}
