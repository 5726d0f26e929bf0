// Programs of the student's own, and the debugger: what they say where something is missing, and what they show.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;

TEST_CASE("an experiment calls the student's functions; one that fails is told, and the first one is written once") {
  CourseCopy().check_story("trying");
}

TEST_CASE("gdb stops in the function at the first failing case, and shows and multiplies vectors as C++ does" *
          doctest::test_suite("thorough")) {
  const CourseCopy course;
  course.answer_energy("const Vector3d twice = 2 * x;\nreturn k * twice.norm();");
  write(course.root() / "typed",
        "info args\nnext\ninfo locals\nprint 2*x - x\nprint x(1) + twice.norm()\nprint x*twice\nprint "
        "nothing\ncontinue\nquit\n");
  const std::string typing = R"(sh -c 'cat typed | "$0" "$@"')";
  const Outcome stepped = course.run("debug spring_energy", typing);
  CHECK_MESSAGE(has(stepped.out, "x = (0, 1, 0)"), stepped.said());
  CHECK(has(stepped.out, "twice = (0, 2, 0)"));
  CHECK(has(stepped.out, "2*x - x = (0, 1, 0)"));
  CHECK(has(stepped.out, "x(1) + twice.norm() = 3"));
  CHECK(has(stepped.err, "a.dot(b)"));
  CHECK(has(stepped.err, "No symbol \"nothing\""));
  CHECK_FALSE(has(stepped.said(), "Python"));
  CHECK(has(stepped.out, "expected = 0.5\nyours = 2\n"));
  const Outcome other = course.run("debug spring_energy --case 2", typing);
  CHECK(has(other.out, "Case 2 "));
  CHECK(course.run("debug spring_energy --case 99999").status == 2);
}

TEST_CASE("every variable of a function is shown at one case, line by line" * doctest::test_suite("thorough")) {
  const CourseCopy course;
  course.answer_energy(
      "const Vector3d twice = 2 * x;\ndouble sum = 0;\nfor (int i = 0; i < 3; ++i)\n  sum += twice[i];\n"
      "const auto lazy = k * x;\nreturn sum + 0 * lazy[0];");
  const Outcome shown = course.run("try --case 2 spring_energy");
  CHECK(shown.status == 0);
  CHECK_FALSE(has(shown.said(), "arning"));
  for (const char* line : {"k = 1\n", "x = (1, 0, 1)\n", "line 4: twice = (2, 0, 2)\n", ": sum = 4\n", ": i = 1\n",
                           "line 8: lazy = a formula that is", "expected = 1\nyours = 4\n"})
    CHECK_MESSAGE(has(shown.out, line), line, shown.said());
  course.answer_energy("double* none = nullptr;\nreturn *none;");
  CHECK_MESSAGE(has(course.run("try --case 2 spring_energy").out, "SIGSEGV"), "a crash");
  CHECK(course.run("try --case 99999 spring_energy").status == 2);
  CHECK(course.run("try --case 2").status == 2);
  CHECK(course.run("try --case 2 nothing").status == 2);
  const Outcome missing = course.run("try --case 2 spring_energy", without_programs);
  CHECK(missing.status == 3);
  CHECK(has(missing.err, "apt-get install gdb"));
}

TEST_CASE("nothing is debugged that is not started or does not compile, or without gdb" *
          doctest::test_suite("thorough")) {
  CourseCopy().check_story("debugging");
}
