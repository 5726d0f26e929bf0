// The commands of a student, one after another, as they change what is remembered.
#include "checker/base/text.hpp"
#include "checker/course/course.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace workbook::testing;
namespace fs = std::filesystem;

TEST_CASE(
    "what passed is remembered while the file is the same; exercises and lectures have several names; reference "
    "results "
    "that a build leaves as they are are not built again") {
  CourseCopy().check_story("remembering");
}

TEST_CASE("bash completes commands, options, exercises and lectures, and else files") {
  CourseCopy().check_story("completing");
}

TEST_CASE("a lecture's topic that is the name of an exercise means the exercise") {
  const CourseCopy course;
  fs::rename(course.root() / "lectures/01_springs", course.root() / "lectures/01_spring_force");
  const workbook::Course renamed(course.root() / "course.json");
  CHECK(renamed.find("spring_force").size() == 1);
  CHECK(renamed.find("01_spring_force").size() == 2);
  CHECK_THROWS_AS(renamed.find("02"), workbook::UsageError);
}

TEST_CASE("two checkers at once each keep what the other writes down") {
  const CourseCopy course;
  const fs::path file = course.root() / ".workbook/progress.json";
  workbook::Progress check(file);
  workbook::Progress hint(file);
  hint.remember_hints("spring_energy", 2);
  check.remember("spring_energy", "passed", "its text");
  hint.remember_hints("spring_force", 1);
  const workbook::Progress both(file);
  CHECK(both.passed("spring_energy", workbook::fingerprint("its text")));
  CHECK(both.of("spring_energy").hints_shown == 2);
  CHECK(both.of("spring_force").hints_shown == 1);
}

TEST_CASE("the report says what to type to see more of the same failure, and it is the same") {
  const CourseCopy course;
  course.answer_energy("return x.squaredNorm() * k * (k > 1.5 ? 1.0 : 0.5);");
  for (const char* seed : {"", " --seed 5"}) {
    const Outcome first = course.run(std::string("check spring_energy") + seed, "WORKBOOK_PROGRAM=./checker/run");
    const workbook::Match more = workbook::search(first.out, "More +\\./checker/run ([^\n,]+)"),
                          shown = workbook::search(first.out, "\n  Case [^\n]+\n[^\n]+\n[^\n]+\n");
    REQUIRE((more && shown));
    CHECK(has(more[1], seed));
    CHECK(has(course.run(more[1], "WORKBOOK_PROGRAM=./checker/run").out, shown[0]));
  }
}

TEST_CASE("no line is wider than the terminal, except for what is typed or opened") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  for (const char* width : {"80", "44"}) {
    for (const char* command : {"", "list", "hint", "hint spring_energy"}) {
      for (const std::string& line : workbook::lines_of(course.run(command, std::string("COLUMNS=") + width).out)) {
        const bool is_typed_or_opened = has(line, "checker ") || has(line, "/");
        CHECK_MESSAGE((is_typed_or_opened || workbook::display_width(line) <= std::stoul(width)), line);
      }
    }
  }
}

TEST_CASE("colour comes on request, NO_COLOR wins, and the plain mode has words for marks and no drawings") {
  const CourseCopy course;
  course.answer_energy("return 0;");
  for (const char* command : {"", "list", "check", "doctor", "hint spring_energy"}) {
    CAPTURE(command);
    CHECK_FALSE(has(course.run(command).out, "\033["));
    CHECK_FALSE(has(course.run(command, "CLICOLOR_FORCE=1 NO_COLOR=1").out, "\033["));
    const std::string plain = course.run(std::string(command) + " --plain", "CLICOLOR_FORCE=1").out;
    for (const char* mark : {"✓", "✗", "·", "\033", "###", "..."}) CHECK_MESSAGE(!has(plain, mark), plain);
  }
  CHECK(has(course.run("list", "CLICOLOR_FORCE=1").out, "\033["));
}

TEST_CASE("a page of the notes is a link on terminals that have links, and an address where they would be dropped") {
  const CourseCopy course;
  write(course.root() / "html/lecture_01_springs.html", "");
  const auto shown = [&](const std::string& environment) {
    return course.run_on_terminal("", 80, 24, environment).shown;
  };
  CHECK(has(shown("TERM=xterm"), "\033]8;;file://"));
  for (const char* dropping : {"TERM=xterm TMUX=x", "TERM=xterm STY=x", "TERM=linux"}) {
    CHECK_FALSE(has(shown(dropping), "\033]8;;"));
    CHECK(has(shown(dropping), "lecture_01_springs.html"));
  }
}

TEST_CASE("what cannot be used is refused by the first program, before the one with all commands is made") {
  const CourseCopy course;
  fs::create_directories(course.root() / "alone");
  fs::copy_file(WORKBOOK_TEST_CHECKER, course.root() / "alone/checker");
  const auto status = [&](const std::string& arguments) {
    return run_command(
               fmt::format("cd '{}' && alone/checker --course course.json {}", course.root().string(), arguments),
               course.root())
        .status;
  };
  for (const char* refused : {"debug spring_enrgy", "report --html lectures", "report --html page.html sprigs",
                              "try nowhere.cpp", "try lectures", "examples 99", "figures 99", "live 99",
                              "self-check 99", "grade lectures --out g --roster no.csv"})
    CHECK_MESSAGE(status(refused) == 2, refused);
  CHECK(status("examples 01") == 3);  // there is no such program here
}
