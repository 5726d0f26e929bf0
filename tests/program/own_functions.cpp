// A function that calls one of an earlier exercise is linked with the student's own, and waits for it where that fails.
#include "checker/pipeline/check_exercise.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;

TEST_CASE(
    "an own function of an earlier exercise is linked, named if it fails, and no other one is needed; a helper of that "
    "name is the one that counts") {
  CourseCopy().check_story("own_functions");
}

TEST_CASE("the verdict on a file that cannot be linked is told before its own functions are waited for") {
  const CourseCopy copy;
  copy.answer_energy("return 7;");
  write(copy.exercise("spring_force"),
        "extern \"C\" double nowhere();\n" + force_text("return nowhere() * spring_energy(k, x) * x;"));
  const workbook::Course course(copy.root() / "course.json");
  workbook::CheckContext context(course);
  std::vector<workbook::Verdict> told;
  const workbook::CheckResult last =
      workbook::check_exercise(context, workbook::check_task(course, course.find_exercise("spring_force")),
                               [&](const workbook::CheckResult& judged) { told.push_back(judged.judgement.verdict); });
  CHECK(told == std::vector{workbook::Verdict::compile_error});  // where the check reaches its limit, this one stays
  CHECK(last.judgement.verdict == workbook::Verdict::waiting);
}
