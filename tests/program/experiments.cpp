// Programs of the student's own, and the debugger: what they say where something is missing, and what they show.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;

TEST_CASE("an experiment calls the student's functions, and names one that is not started") {
  const CourseCopy course;
  write(course.root() / "a try.cpp",
        "#include <rigid/springs.hpp>\nint main() { std::cout << rigid::spring_energy(2, {1, 2, 2}) << '\\n'; return "
        "7; }\n");
  const Outcome without = course.run("try 'a try.cpp'");
  CHECK(without.status == 1);
  CHECK_MESSAGE(has(without.err, "spring_energy is not started"), without.err);
  course.solve("spring_energy");
  const Outcome with = course.run("try 'a try.cpp'");
  CHECK(with.status == 7);  // the program's own
  CHECK(with.out == "9\n");
  course.answer_energy("return x[5];");
  CHECK(has(course.run("try 'a try.cpp'").err, "Eigen stopped the calculation"));
}

TEST_CASE("an experiment that does not compile, or is not there, is told with its place") {
  const CourseCopy course;
  write(course.root() / "odd.cpp", "int main() {\n  return y;\n}\n");
  const Outcome odd = course.run("try odd.cpp");
  CHECK(odd.status == 1);
  CHECK_MESSAGE(has(odd.err, "odd.cpp:2:10: error"), odd.err);
  CHECK(course.run("try nowhere.cpp").status == 2);
}

TEST_CASE("the first experiment is written once, and not over one that is there") {
  const CourseCopy course;
  const auto file = course.root() / "lectures/try.cpp";
  course.run("try");
  CHECK(has(read(file), "int main()"));
  write(file, "int main() { return 4; }\n");
  CHECK(course.run("try").status == 4);
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
  const CourseCopy course;
  const Outcome untouched = course.run("debug spring_energy");
  CHECK(untouched.status == 1);
  CHECK(has(untouched.out, "not started"));
  course.answer_energy("return k");
  const Outcome broken = course.run("debug spring_energy");
  CHECK(broken.status == 1);
  CHECK(has(broken.out, "compile error"));
  const Outcome missing = course.run("debug spring_energy", without_programs);
  CHECK(missing.status == 3);
  CHECK(has(missing.err, "apt-get install gdb"));
  CHECK(course.run("debug --build-only spring_energy --case 1").status == 1);  // does not compile
}
