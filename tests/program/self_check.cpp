// self-check: every fault that an author can make is found, with the file and the fix.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

/// The file is named once and in the first word of a line, and the sentence says what is needed.
void require_fault(const CourseCopy& course, const std::string& file, const std::string& fix) {
  const Outcome outcome = course.run("self-check --seeds 1");
  CHECK(outcome.status == 1);
  CHECK_MESSAGE(has(outcome.out, file + ": "), outcome.out);
  CHECK_MESSAGE(has(outcome.out, fix), outcome.out);
}

}  // namespace

TEST_CASE("self-check finds nothing in a course that is in order, nor in parts of it") {
  const CourseCopy course;
  for (const char* names : {"", "01", "spring_energy"}) {
    const Outcome outcome = course.run(std::string("self-check --seeds 1 ") + names);
    CHECK_MESSAGE(outcome.status == 0, (outcome.out + outcome.err));
  }
  CHECK(has(course.run("self-check --seeds 3").out, "2 exercises, 6 right routes, 6 wrong answers, 3 seeds"));
  CHECK(
      has(course.run("self-check --seeds 1 spring_energy").out, "1 exercise, 3 right routes, 3 wrong answers, 1 seed"));
}

TEST_CASE("self-check names all missing parts of an exercise in one message") {
  const CourseCopy course;
  replace_in(
      course.card(), "\"exercises\": [",
      "\"exercises\": [ {\"name\": \"ghost\", \"points\": 1, \"notes\": \"springs_ghost\", \"task\": \"None.\"},");
  const Outcome outcome = course.run("self-check ghost");
  CHECK(outcome.status == 1);
  for (const char* file :
       {"include/rigid/springs.hpp", "lectures/01_springs/hints/ghost.md", "lectures/01_springs/notes.md",
        "lectures/01_springs/exercises/ghost.cpp", "solutions/01_springs/ghost.cpp",
        "solutions/01_springs/judging/ghost.cpp", "solutions/01_springs/derivations/ghost.md"})
    CHECK_MESSAGE(has(outcome.out, std::string("\n  ") + file + ": "), outcome.out);
  CHECK(has(outcome.out, "\n1 fault to fix."));
  CHECK(has(course.run("check ghost").out, "self-check ghost"));
}

TEST_CASE("self-check finds a fault of one file") {
  const struct {
    const char* file;
    const char* from;  ///< empty: the file is new
    const char* to;
    const char* fix;
    const char* named = file;
  } faults[] = {
      {"lectures/01_springs/exercises/spring_energy.cpp", "throw NotStarted{};", "return 0.5 * k * x.squaredNorm();",
       "`checker reset spring_energy`"},
      {"solutions/01_springs/spring_force.cpp", "-k * x", "k * x", "the verdict is wrong_value, not passed"},
      {"lectures/01_springs/exercises/spring_old.cpp", "", "// forgotten\n", "no card lists it"},
      {"lectures/01_springs/worked_examples.cpp", "//! [energy]", "//", "'energy'", "lectures/01_springs/notes.md"},
      {"lectures/01_springs/card.json", "\"facts\": [1]", "\"facts\": [1, 2]", "<!-- fact 2 -->",
       "lectures/01_springs/notes.md"},
      {"include/rigid/springs.hpp", "spring_energy(double k", "spring_energy(double stiffness",
       "double spring_energy(double k, const Vector3d& x)"},
  };
  for (const auto& fault : faults) {
    CAPTURE(fault.file);
    const CourseCopy course;
    if (*fault.from == '\0')
      write(course.root() / fault.file, fault.to);
    else
      replace_in(course.root() / fault.file, fault.from, fault.to);
    require_fault(course, fault.named, fault.fix);
  }
}

TEST_CASE("self-check finds hints that are too few and a card that points nowhere, and neither hides the other") {
  const CourseCopy course;
  const std::string hints = "lectures/01_springs/hints/spring_energy.md";
  replace_in(course.notes(), "{#springs_force}", "");
  write(course.root() / hints, "Read.\n\n---\n\nThink.\n");
  require_fault(course, hints, "2 hints instead of 3");
  require_fault(course, "lectures/01_springs/notes.md", "{#springs_force}");
}

TEST_CASE("self-check finds a command that Doxygen does not know, or takes for another") {
  const CourseCopy course;
  write(course.root() / "lectures/site/Doxyfile.in", "ALIASES = \"computed{2}=x\"\nALIASES += \"source=x\"\n");
  const std::string notes = read(course.notes());
  for (const char* known : {"\\ref x and \\source", "`\\nosuch`", "\\f$ \\vec\nx \\f$", "\\f[ \\vec x \\f]"}) {
    write(course.notes(), notes + known + "\n");
    CHECK_MESSAGE(course.run("self-check --seeds 1").status == 0, known);
  }
  for (const char* command : {"\\nosuch", "\\snippet{x}", "\\computed", "\\computed{x}", "\\source{x}"}) {
    write(course.notes(), notes + "See " + command + " x\n");
    require_fault(course, "lectures/01_springs/notes.md", fmt::format("no command reads '{}'", command));
  }
}

TEST_CASE("self-check finds cases outside the contract") {
  const CourseCopy course;
  const auto demanding = [&](const std::string& condition) {
    replace_in(course.root() / "include/rigid/springs.hpp", "/// Force of", "/// @pre " + condition + "\n/// Force of");
  };
  demanding("0 < k and |x| > 7; spring < k");
  CHECK(course.run("self-check --seeds 1").status == 0);
  demanding("0 < k < 0.001, where x is small");
  require_fault(course, "solutions/01_springs/judging/spring_force.cpp",
                "is outside the contract, which demands 0 < k < 0.001");
}

TEST_CASE("self-check finds a formula among the words about a problem") {
  const CourseCopy course;
  replace_in(course.card(), "\"points\": 2", "\"points\": 2, \"problem\": true, \"difficulty\": 1, \"minutes\": 20");
  require_fault(course, "solutions/01_springs/judging/spring_energy.cpp", "'The factor ½ is missing.' holds a formula");
}

TEST_CASE("self-check finds a problem that names no limits, and an exercise after a problem") {
  const CourseCopy course;
  const auto said = [&] { return course.run("self-check --seeds 1").out; };
  CHECK_FALSE(has(said(), "limits"));
  replace_in(course.card(), "\"points\": 2", "\"points\": 2, \"problem\": true, \"difficulty\": 1, \"minutes\": 20");
  require_fault(course, "solutions/01_springs/judging/spring_energy.cpp", "a problem names 2 limits (`e.limit`)");
  require_fault(course, "lectures/01_springs/card.json",
                "'spring_force' stands after a problem or after what is harder");
  // spring_force names two.
  replace_in(course.card(), "\"points\": 1", "\"points\": 1, \"problem\": true, \"difficulty\": 1, \"minutes\": 20");
  CHECK_FALSE(has(said(), "spring_force names"));
  CHECK_FALSE(has(said(), "stands after"));
}

TEST_CASE("self-check finds the formula of a problem in the notes and in quoted code, and not where it is folded") {
  const CourseCopy course;
  const std::string formula = "\\f[ E = \\frac{k}{2}\\left( x_1^2 + x_2^2 + x_3^2 \\right) . \\f]\n";
  const std::string same = "\\f$ E = \\frac k2 (x_1^2 + x_2^2 + x_3^2) \\f$\n";
  const fs::path derivation = course.root() / "solutions/01_springs/derivations/spring_energy.md";
  const fs::path example = course.root() / "lectures/01_springs/worked_examples.cpp";
  const std::string notes = read(course.notes()), code = read(example);
  replace_in(course.card(), "\"points\": 2", "\"points\": 2, \"problem\": true, \"difficulty\": 1, \"minutes\": 20");
  write(derivation, "# Energy\n\n" + formula + "\n*Wrong turns.* None.\n");
  replace_in(course.solution("spring_energy"), "0.5 * k * x.squaredNorm()",
             "0.5 * k * (std::pow(x[0], 2) + x.tail<2>().squaredNorm())");
  const auto said = [&] { return course.run("self-check --seeds 1").out; };
  CHECK_MESSAGE(!has(said(), "problem spring_energy"), said());

  write(course.notes(), notes + "\n" + same);
  require_fault(course, "lectures/01_springs/notes.md", "gives away the formula of the problem spring_energy");
  for (const std::string fold : {"\\solved{spring_energy}", "\\folded{Later}"}) {
    write(course.notes(), notes + "\n" + fold + "\n" + same + "\\endfolded\n");
    CHECK_MESSAGE(!has(said(), "problem spring_energy"), said());
  }

  write(example,
        "//! [energy]\nauto e = 0.5 * stiffness * (pow(r[0], 2) + r.tail<2>().squaredNorm());\n//! [energy]\n");
  require_fault(course, "lectures/01_springs/worked_examples.cpp", "the solution of the problem spring_energy returns");
  write(example, "//! [energy]\nauto e = 0.5 * r * (pow(r[0], 2) + r.tail<2>().squaredNorm());\n//! [energy]\n");
  CHECK_MESSAGE(!has(said(), "problem spring_energy"), said());
}

TEST_CASE("a stray file is a remark and stops nothing") {
  const CourseCopy course;
  write(course.root() / "lectures/01_springs/exercises/spring_enrgy.cpp", "int main() { return 0; }\n");
  const Outcome listed = course.run("list");
  CHECK(listed.status == 0);
  CHECK(has(listed.err, "exercises/spring_enrgy.cpp"));
  CHECK(has(listed.err, "spring_energy.cpp"));
  CHECK(course.run("check --json").json().at("results").size() == 2);
}

TEST_CASE(
    "self-check names lost digits and a record of typical bugs that does not fit, and writes a new one when asked") {
  const CourseCopy course;
  const fs::path record = course.root() / "solutions/01_springs/judging/adequacy.json";
  const std::string before = read(record);
  CHECK(course.run("self-check --prove").status == 0);

  {
    const CourseCopy worse;
    worse.stand_in("reference/rounding_01_springs", R"(printf '0.5\tspring_energy\ta case, the solution\n')");
    const Outcome rounded = worse.run("self-check --prove spring_energy");
    CHECK(rounded.status == 1);
    CHECK_MESSAGE(has(rounded.out, "spring_energy.cpp: rounding takes 0.5 of the tolerance at a case, the solution.\n"),
                  rounded.said());
  }

  write(record, "{}\n");
  const Outcome differs = course.run("self-check --prove spring_energy");
  CHECK(differs.status == 1);
  CHECK_MESSAGE(has(differs.out, "solutions/01_springs/judging/spring_energy.cpp: "), differs.out);
  CHECK(has(differs.out, "self-check --record"));
  CHECK(read(record) == "{}\n");

  CHECK(course.run("self-check --record").status == 0);
  CHECK(read(record) == before);
  write(record, "{\n");
  CHECK_MESSAGE(has(course.run("self-check --prove").said(), "adequacy.json"), "a damaged record is named");
  fs::remove_all(course.root() / "solutions");
  CHECK(course.run("self-check --record").status == 2);
}

TEST_CASE("self-check names the changes of a solution that no case finds, and says why they cannot be tried") {
  const CourseCopy course;
  const Outcome all_found = course.run("self-check --prove 01");
  CHECK_MESSAGE(all_found.status == 0, all_found.said());
  CHECK(has(all_found.out, "01 spring_energy"));

  const std::string of_force = "solutions/01_springs/judging/spring_force.cpp: ";
  replace_in(course.solution("spring_force"), "-k * x", "-k * x * std::cos(1e-30)");
  const Outcome survived = course.run("self-check --prove spring_force");
  CHECK(survived.status == 1);
  CHECK_MESSAGE((has(survived.out, of_force) && has(survived.out, "line 5, another number: ")), survived.out);
  CHECK(!has(survived.out, "spring_energy"));

  replace_in(course.solution("spring_force"), "-k * x", "k * x");
  const Outcome wrong = course.run("self-check --prove 01");
  CHECK(wrong.status == 1);
  CHECK_MESSAGE((has(wrong.out, of_force) && has(wrong.out, "does not pass")), wrong.out);
  CHECK(has(wrong.out, "01 spring_energy"));
  fs::remove_all(course.root() / "solutions");
  CHECK(course.run("self-check --prove").status == 2);
}

TEST_CASE("a new exercise has its heading before what ends the lecture") {
  const CourseCopy course;
  const std::string before = read(course.notes());
  write(course.notes(), before + "\n## Questions {#springs_questions}\n\n\\slides\n\\endslides\n");
  const Outcome made = course.run("new exercise spring_power --lecture 01 --signature 'double spring_power(double k)'");
  REQUIRE_MESSAGE(made.status == 0, made.said());
  CHECK(read(course.notes()) == before +
                                    "\n### Spring power {#springs_spring_power}\n\nTODO\n\n## Questions "
                                    "{#springs_questions}\n\n\\slides\n\\endslides\n");
}
