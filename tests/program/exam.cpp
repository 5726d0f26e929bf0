// An exam that a student sets himself, and what is left of a lecture.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <ctime>

using namespace workbook::testing;

namespace {

/// The tiny course with both of its exercises as problems.
class CourseOfProblems : public CourseCopy {
 public:
  CourseOfProblems() {
    replace_in(card(), "\"points\": 2", "\"points\": 2, \"problem\": true, \"difficulty\": 1, \"minutes\": 20");
    replace_in(card(), "\"points\": 1", "\"points\": 1, \"problem\": true, \"difficulty\": 1, \"minutes\": 15");
  }
  std::filesystem::path exam() const { return root() / ".workbook/exam.json"; }
};

}  // namespace

TEST_CASE("an exam draws problems that were not seen, by its seed, and shows them with the time") {
  const CourseOfProblems course;
  const Outcome drawn = course.run("exam 01 --seed 3 --minutes 90");
  CHECK_MESSAGE(drawn.status == 0, drawn.said());
  CHECK(has(drawn.out, "Exam of 1 h 30 min: 1 h 30 min left"));
  CHECK(has(drawn.out, "spring_energy"));
  CHECK(has(drawn.out, "spring_force"));
  const auto kept = nlohmann::json::parse(read(course.exam()));
  CHECK(kept.at("seed") == 3);
  CHECK(kept.at("minutes") == 90);
  CHECK(has(course.run("exam").out, "1 h 30 min left"));
  CHECK(has(course.run("").out, "An exam is running, 1 h 30 min left"));
  // Without --minutes it may take what its problems take together, and what was seen is not drawn.
  for (const char* seen : {"check spring_energy", "hint spring_energy"}) {
    const CourseOfProblems other;
    if (has(seen, "check")) other.answer_energy("return 0;");
    other.run(seen);
    const Outcome second = other.run("exam 01-01");
    CHECK_MESSAGE(has(second.out, "Exam of 15 min"), seen);
    CHECK_FALSE(has(second.out, "spring_energy"));
  }
  CHECK(has(CourseOfProblems().run("exam springs").out, "Exam of 35 min"));
  CHECK(has(CourseOfProblems().run("exam 1 --minutes 60").out, "Exam of 1 h: 1 h left"));
}

TEST_CASE("while an exam runs nothing helps with its problems, and other exercises are as ever") {
  const CourseOfProblems course;
  course.run("hint spring_force");  // seen, so the exam is about the other one
  REQUIRE(course.run("exam 01").status == 0);
  for (const char* help : {"hint spring_energy", "hint", "solution spring_energy", "solution spring_energy --now",
                           "check spring_energy", "check", "check 01 --json", "plot spring_energy", "watch",
                           "predict spring_energy", "question spring_energy", "report --html page.html"}) {
    const Outcome refused = course.run(help);
    CHECK_MESSAGE(refused.status == 2, help);
    CHECK_MESSAGE(has(refused.err, "spring_energy is a problem of the exam that is running"), help);
    CHECK_MESSAGE(refused.out.empty(), help);
  }
  CHECK(course.run("hint spring_force").status == 0);
  CHECK(course.run("list").status == 0);
  course.run("exam --finish");
  CHECK(course.run("hint spring_energy").status == 0);
}

TEST_CASE("an exam is graded at its end, with a table, the points and the time") {
  const CourseOfProblems course;
  course.run("exam 01");
  course.solve("spring_force");
  course.answer_energy("return k * x.squaredNorm();");
  const Outcome graded = course.run("exam --finish");
  CHECK(graded.status == 1);
  CHECK_MESSAGE(has(graded.out, "1 of 3 points, in 0 min of 35 min"), graded.said());
  CHECK(has(graded.out, "wrong value"));
  CHECK_FALSE(has(graded.out, "factor"));  // no reasons
  CHECK(!std::filesystem::exists(course.exam()));
  CHECK(has(course.run("list").out, "passed"));
  CHECK(course.run("exam --finish").status == 2);

  const CourseOfProblems late;
  late.run("exam 01 --minutes 30");
  auto kept = nlohmann::json::parse(read(late.exam()));
  kept["started"] = std::time(nullptr) - 45 * 60;
  write(late.exam(), kept.dump());
  CHECK(has(late.run("exam").out, "over time by 15 min"));
  late.solve("spring_force");
  late.solve("spring_energy");
  const Outcome over = late.run("exam --finish");
  CHECK(over.status == 0);
  CHECK_MESSAGE(has(over.out, "3 of 3 points, in 45 min of 30 min: over time"), over.said());
}

TEST_CASE("what no exam can be made of is refused in a sentence, before anything is written") {
  const CourseOfProblems course;
  const struct {
    const char* typed;
    const char* said;
  } slips[] = {{"exam", "No exam is running"},
               {"exam --finish", "No exam is running"},
               {"exam 07", "no lecture"},
               {"exam 01-07", "no lecture"},
               {"exam 01-", "lacks a lecture"},
               {"exam 01 --finish", "leave out the lectures"},
               {"exam 01 --minutes -5", "--minutes"},
               {"exam 01 --minutes 100000", "--minutes"},
               {"exam 01 02", "further argument"}};
  for (const auto& slip : slips) {
    const Outcome refused = course.run(slip.typed);
    CHECK_MESSAGE(refused.status == 2, slip.typed);
    CHECK_MESSAGE(has(refused.err, slip.said), refused.said());
    CHECK_MESSAGE(!std::filesystem::exists(course.exam()), slip.typed);
  }
  const CourseCopy without_problems;
  CHECK(has(without_problems.run("exam 01").err, "no problem in '01' that you have not seen"));
  course.run("exam 01");
  CHECK(has(course.run("exam 01").err, "An exam is running already"));
  const Outcome other_time = course.run("exam --minutes 90");
  CHECK(other_time.status == 2);
  CHECK(has(other_time.err, "The exam that is running has 35 min; --minutes is for a new one."));
  write(course.exam(), "{");
  const Outcome damaged = course.run("hint spring_energy");
  CHECK(damaged.status == 2);
  CHECK(has(damaged.err, "exam.json is damaged"));
}

TEST_CASE("list says what is left of a lecture and how to go through it") {
  const CourseOfProblems course;
  const Outcome begun = course.run("list");
  CHECK_MESSAGE(has(begun.out, "3 points, 35 min left"), begun.out);
  CHECK(has(begun.out, "Plan for 01_springs"));
  CHECK(has(begun.out, "problems      35 min  spring_energy and spring_force"));
  CHECK_FALSE(has(begun.out, "\n  exercises"));
  course.solve("spring_energy");
  course.run("check spring_energy");
  CHECK(has(course.run("list").out, "problems      15 min  spring_force"));
  // Of an assignment only what it asks for.
  write(course.root() / "lectures/assignment.json", R"({"title": "Week 1", "exercises": ["spring_energy"]})");
  CHECK_FALSE(has(course.run("list").out, "Plan for"));
}
