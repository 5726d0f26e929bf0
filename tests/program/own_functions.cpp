// A function that calls one of an earlier exercise is linked with the student's own, and waits for it where that fails.
#include "checker/pipeline/check_exercise.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;

namespace {

/// −k x from the energy ½ k x².
void answer_force_by_energy(const CourseCopy& course, const std::string& factor = "-2") {
  write(course.exercise("spring_force"),
        "#include <rigid/springs.hpp>\n\nnamespace rigid {\nVector3d spring_force(double k, const Vector3d& x) {\n"
        "  if (x.isZero(0)) return x;\n  return " +
            factor + " * spring_energy(k, x) / x.squaredNorm() * x;\n}\n}\n");
}

nlohmann::json checked(const CourseCopy& course, const std::string& options = "") {
  return course.run("check spring_force --json " + options).result();
}

}  // namespace

TEST_CASE("an own function of an earlier exercise is linked, and a failure is explained as ever") {
  const CourseCopy course;
  course.solve("spring_energy");
  answer_force_by_energy(course);
  CHECK(checked(course).at("verdict") == "passed");
  answer_force_by_energy(course, "2");
  const auto wrong = checked(course);
  CHECK(wrong.at("verdict") == "wrong_value");
  CHECK(!wrong.at("diagnosis").empty());
  CHECK(!wrong.contains("waiting_for"));
  answer_force_by_energy(course, "x[3]");
  CHECK(checked(course).at("findings").at(0).at("line") == 6);  // the diagnostic run has the own function too
}

TEST_CASE("an own function that fails is named, whatever is wrong with it, and passing needs no other one") {
  const CourseCopy course;
  answer_force_by_energy(course);
  const auto waits_for_energy = [&](const std::string& reason) {
    CAPTURE(reason);
    const auto result = checked(course);
    CHECK(result.at("verdict") == "waiting");
    CHECK(result.at("score") == 0.0);
    CHECK(result.at("waiting_for") == nlohmann::json{"spring_energy"});
    CHECK(has(result.at("message"), "spring_energy (" + reason + ")"));
    CHECK(result.at("first_failure").is_null());
  };
  waits_for_energy("not started");
  course.answer_energy("return k * x.squaredNorm();");
  waits_for_energy("wrong value");
  course.answer_energy("return 0.5 * k * x.squaredNorm()");
  waits_for_energy("compile error");
  course.answer_energy("return k;");
  replace_in(course.exercise("spring_energy"), "spring_energy", "spring_enrgy");
  waits_for_energy("missing function");

  // Named, but not called.
  write(course.exercise("spring_force"),
        "#include <rigid/springs.hpp>\n\nnamespace rigid {\nVector3d spring_force(double k, const Vector3d& x) {\n"
        "  const double spring_energy = k;\n  return -spring_energy * x;\n}\n}\n");
  CHECK(checked(course).at("verdict") == "passed");
}

TEST_CASE("a file elsewhere is linked with the file beside it, and helpers of one name are named") {
  const CourseCopy course;
  answer_force_by_energy(course);
  const auto folder = course.root() / "handed in";
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(course.solution("spring_energy"), folder / "spring_energy.cpp");
  std::filesystem::copy_file(course.exercise("spring_force"), folder / "spring_force.cpp");
  CHECK(checked(course, "--file 'handed in/spring_force.cpp'").at("verdict") == "passed");
  CHECK(checked(course).at("verdict") == "waiting");

  for (const char* file : {"spring_energy.cpp", "spring_force.cpp"})
    replace_in(folder / file, "namespace rigid {", "int helper() { return 1; }\nnamespace rigid {");
  const auto twice = checked(course, "--file 'handed in/spring_force.cpp'");
  CHECK(twice.at("verdict") == "compile_error");
  CHECK(twice.at("findings").at(0).at("name") == "defined_twice");
  CHECK(twice.at("findings").at(0).at("line") == 3);
}

TEST_CASE("an own function may not use what no earlier exercise defines") {
  const CourseCopy course;
  course.solve("spring_force");
  course.answer_energy("return spring_force(k, x).norm();");
  const auto result = course.run("check spring_energy --json").result();
  CHECK(result.at("verdict") == "compile_error");
  CHECK(result.at("findings").at(0).at("name") == "undefined_function");
}

TEST_CASE("the verdict on a file that cannot be linked is told before its own functions are waited for") {
  const CourseCopy copy;
  copy.answer_energy("return 7;");
  answer_force_by_energy(copy, "nowhere()");
  replace_in(copy.exercise("spring_force"), "namespace rigid {", "extern \"C\" double nowhere();\nnamespace rigid {");
  const workbook::Course course(copy.root() / "course.json");
  workbook::CheckContext context(course);
  std::vector<workbook::Verdict> told;
  const workbook::CheckResult last =
      workbook::check_exercise(context, workbook::check_task(course, course.find_exercise("spring_force")),
                               [&](const workbook::CheckResult& judged) { told.push_back(judged.judgement.verdict); });
  CHECK(told == std::vector{workbook::Verdict::compile_error});  // where the check reaches its limit, this one stays
  CHECK(last.judgement.verdict == workbook::Verdict::waiting);
}

TEST_CASE("a helper may be called like a function of the course, and in its file it is the one that counts") {
  const CourseCopy course;
  course.answer_energy("return 7;");  // is not asked
  const std::string plain = "double spring_energy(double k, const Vector3d& x) { return k * x.norm(); }\n";
  for (const std::string& helper : {"namespace {\n" + plain + "}\n", "static " + plain, plain}) {
    CAPTURE(helper);
    const auto answered = [&](const std::string& result) {
      write(course.exercise("spring_force"), "#include <rigid/springs.hpp>\nnamespace rigid {\n" + helper +
                                                 "Vector3d spring_force(double k, const Vector3d& x) {\n  return " +
                                                 result + ";\n}\n}\n");
      return course.run("check spring_force --json").result();
    };
    CHECK(answered("x.isZero(0) ? x : Vector3d(-spring_energy(k, x) / x.norm() * x)").at("verdict") == "passed");
    if (helper != plain) continue;
    CHECK(answered("spring_energy(k, x) * x").at("verdict") == "wrong_value");
    const auto typo = answered("spring_energy(k, x) * x + y");
    CHECK(typo.at("verdict") == "compile_error");
    CHECK_MESSAGE((!has(typo.dump(), "own_") && has(typo.dump(), "`y`")), typo.dump());
  }
}
