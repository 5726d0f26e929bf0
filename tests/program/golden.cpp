// What people read, screen by screen. See check_golden() for how these files are written anew.
#include "checker/base/text.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <regex>

using namespace workbook::testing;

namespace {

/// A course in which one exercise has a known mistake.
struct CourseWithMistake : CourseCopy {
  CourseWithMistake() { answer_energy("return k * x.squaredNorm();"); }
};

}  // namespace

TEST_CASE("a tour at 44 columns, and its beginning in the plain mode") {
  const CourseWithMistake course;
  std::string screens =
      course.screens({"", "check", "list", "", "hint spring_energy", "hint", "hint", "hint --all"}, "COLUMNS=44");
  course.solve("spring_energy");
  screens += course.screens({"check spring_energy", "check spring_energy --case 2", ""}, "COLUMNS=44");
  course.solve("spring_force");
  screens += course.screens({"check", "", "hint"}, "COLUMNS=44");
  check_golden("44_columns", screens);

  const CourseWithMistake other;
  check_golden("plain", other.screens({"", "check", "list"}, "COLUMNS=80 WORKBOOK_PLAIN=1"));
}

TEST_CASE("screens of failures") {
  const CourseCopy course;
  std::string screens;
  for (const char* body : {"return 0.5 * k * x^2;", "return x(7);", "int* p = nullptr; *p = 1; return k;", "throw 3;",
                           "std::cout << \"k = \" << k << \"\\n\"; return k > 3 ? 0.0 : 0.5 * k * x.squaredNorm();",
                           "return 0.5000001 * k * x.squaredNorm();", "return 0.5 * x.squaredNorm();"}) {
    course.answer_energy(body);
    screens += std::string("{ ") + body + " }\n" + course.screens({"check spring_energy"});
  }
  check_golden("failures", screens);
}

TEST_CASE("the help names every command; that of a command says what each option means, no wider than the terminal") {
  const CourseCopy course;
  check_golden("help", course.screens({"--help"}));
  const std::string help = course.run("--help", "COLUMNS=80").out;
  const std::regex entry("\n  ([a-z][a-z-]+) +[A-Z]"), bare_option("  -[^ ]*( [A-Z.]+)*");
  int commands = 0;
  for (std::sregex_iterator match(help.begin(), help.end(), entry), end; match != end; ++match, ++commands) {
    for (const char* width : {"44", "80"}) {
      const Outcome shown = course.run((*match)[1].str() + " --help", std::string("COLUMNS=") + width);
      CHECK(shown.status == 0);
      const std::vector<std::string> lines = workbook::lines_of(shown.out);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        CAPTURE(lines[i]);
        if (!lines[i].starts_with("  checker ")) CHECK(workbook::display_width(lines[i]) <= std::stoul(width));
        if (std::regex_match(lines[i], bare_option))
          CHECK_MESSAGE(lines.at(i + 1).starts_with("            "), lines[i]);
      }
    }
  }
  CHECK(commands > 20);
}

TEST_CASE("wrong usage and names that mean nothing") {
  const CourseCopy course;
  course.solve("spring_energy");
  write(course.root() / "draft.cpp", read(course.solution("spring_energy")));
  write(course.root() / "blocked", "a file where a folder should be");
  const std::string screens = course.screens({"chek",
                                              "spring_energy",
                                              "quaternion",
                                              "check --sed 5",
                                              "check --seed many",
                                              "hint spring_energy spring_force",
                                              "check spring_enrgy",
                                              "check quaternion",
                                              "check 7",
                                              "check draft.cpp",
                                              "check nowhere/spring_energy.cpp",
                                              "check --file draft.cpp",
                                              "check --case one",
                                              "check spring_energy --case on",
                                              "check spring_energy --case quaternion",
                                              "plot",
                                              "plot --all spring_energy",
                                              "plot springs --file draft.cpp",
                                              "plot spring_energy --picture oil",
                                              "plot spring_energy --out blocked",
                                              "plot spring_energy --out blocked/below",
                                              "report",
                                              "report --html blocked/page.html",
                                              "report --html lectures",
                                              "report --html page.html --file draft.cpp",
                                              "hint spring_enrgy",
                                              "reset spring_enrgy",
                                              "debug spring_enrgy",
                                              "try nowhere.cpp",
                                              "try lectures",
                                              "check --seed -1",
                                              "check --seed 99999999999999999999",
                                              "check spring_energy --file nowhere.cpp",
                                              "check spring_energy --file lectures",
                                              "report --html ''",
                                              "figures springs --seconds 0",
                                              "hint springs",
                                              "grade lectures --out grades --roster nowhere.csv",
                                              "grade nowhere.zip --out grades",
                                              "grade lectures --out blocked/grades",
                                              "handout blocked/copy",
                                              "examples sprigs",
                                              "figures sprigs",
                                              "live sprigs",
                                              "solution spring_enrgy",
                                              "question spring_enrgy",
                                              "predict spring_enrgy",
                                              "predict spring_energy 9999=1",
                                              "predict spring_energy one",
                                              "exam 77",
                                              "exam springs --minutes -5",
                                              "review spring_energy",
                                              "update",
                                              "update nowhere",
                                              "reset",
                                              "debug",
                                              "try --case 3",
                                              "watch quaternion",
                                              "list springs",
                                              "prepare springs",
                                              "doctor --full",
                                              "--plane"});
  check_golden("wrong_usage", screens);
  CHECK(!std::regex_search(screens, std::regex("\n\\[[^2]")));
}

TEST_CASE("without gnuplot") {
  const CourseWithMistake course;
  check_golden("without_gnuplot",
               course.screens({"plot spring_energy", "plot --all", "figures springs", "check spring_energy",
                               "check spring_energy --plot", "report --html page.html"},
                              without_programs));
}
