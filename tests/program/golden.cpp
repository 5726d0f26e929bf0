// What people read, screen by screen. See check_golden() for how these files are written anew.
#include "checker/base/text.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;

namespace {

/// A course in which one exercise has a known mistake.
struct CourseWithMistake : CourseCopy {
  CourseWithMistake() { answer_energy("return k * x.squaredNorm();"); }
};

}  // namespace

TEST_CASE("a tour at 44 columns, and its beginning in the plain mode") {
  CourseWithMistake().check_story("44_columns", "COLUMNS=44");
  CourseWithMistake().check_story("plain", "COLUMNS=80 WORKBOOK_PLAIN=1");
}

TEST_CASE("solutions, hints, cases by name and what has changed no value") { CourseCopy().check_story("helping"); }

TEST_CASE("predictions are judged, of limits first, and the wrong functions that would agree are told") {
  CourseCopy().check_story("predicting");
}

TEST_CASE("an exercise of an earlier lecture comes back when it is due, and its first verdict is kept") {
  CourseCopy().check_story("reviewing");
}

TEST_CASE("after a pass comes a question with one right answer, and the first answer is kept") {
  CourseCopy().check_story("questioning");
}

TEST_CASE("an exam draws problems that were not seen; while it runs nothing helps with them; it is graded at its end") {
  CourseCopy().check_story("exam");
}

TEST_CASE("a reset keeps every version and brings a lost file back; one that fails loses nothing") {
  CourseCopy().check_story("resetting");
}

TEST_CASE("screens of failures") { CourseCopy().check_story("failures"); }

TEST_CASE("the help names every command; that of a command says what each option means, no wider than the terminal") {
  const CourseCopy course;
  check_golden("help", course.screens({"--help"}));
  const std::string help = course.run("--help", "COLUMNS=80").out;
  const std::vector<workbook::Match> commands = workbook::search_all(help, "\n  ([a-z][a-z-]+) +[A-Z]");
  for (const workbook::Match& each : commands) {
    for (const char* width : {"44", "80"}) {
      const Outcome shown = course.run(each[1] + " --help", std::string("COLUMNS=") + width);
      CHECK(shown.status == 0);
      const std::vector<std::string> lines = workbook::lines_of(shown.out);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        CAPTURE(lines[i]);
        if (!lines[i].starts_with("  checker ")) CHECK(workbook::display_width(lines[i]) <= std::stoul(width));
        if (workbook::search(lines[i], "^  -[^ ]*( [A-Z.]+)*$"))
          CHECK_MESSAGE(lines.at(i + 1).starts_with("            "), lines[i]);
      }
    }
  }
  CHECK(commands.size() > 20);
}

TEST_CASE("wrong usage and names that mean nothing") {
  CHECK_FALSE(workbook::search(CourseCopy().check_story("wrong_usage"), "\n\\[[^2]"));
}

TEST_CASE("without gnuplot") { CourseWithMistake().check_story("without_gnuplot", without_programs); }
