// Plots in files and on the terminal, figures, worked examples, and every picture at once.
#include "checker/base/text.hpp"
#include "checker/data/reference_results.hpp"
#include "checker/report/reports.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

using namespace workbook;
using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

const std::string plot = "plot spring_energy --out pictures";
const std::string letters_of_student = "A your E";

struct CourseToDraw : CourseCopy {
  CourseToDraw() { answer_energy("return k * x.squaredNorm();"); }
};

/// A build that leaves its output in a file, as checker/setup.sh does.
constexpr const char* failed_build =
    "mkdir -p build; echo ../lectures/01_springs/exercises/spring_energy.cpp:3:4: error: no >build/build.log; exit 1";

/// As if the build had made the program of the lecture's figures.
void give_figures(const CourseCopy& course) {
  fs::create_directories(course.root() / "build/lectures");
  fs::copy_file(WORKBOOK_TEST_FIGURES, course.root() / "build/lectures/draw_of_the_student_01_springs");
}

/// `checker examples springs`, where building does the first and running the second.
std::string examples(const CourseCopy& course, const std::string& build, const std::string& run) {
  course.stand_in("setup.sh", build);
  course.stand_in("build/lectures/worked_examples_of_the_student_01_springs", run);
  return course.screens({"examples springs"});
}

}  // namespace

TEST_CASE(
    "plots are written as SVG and PNG, of wrong answers of the judging too, half a picture never, and "
    "none by gnuplot's settings of the user") {
  CourseCopy().check_story("plots");
}

TEST_CASE("a curve breaks where there is no value") {
  const CourseCopy course;
  course.answer_energy("if (x[0] > 0.7 && x[0] < 1.3) throw 1; return 0.5 * k * x.squaredNorm();");
  const auto lines_of_student = [&] {
    REQUIRE(course.run(plot).status == 0);
    const std::string svg = read(course.root() / "pictures/spring_energy.svg");
    const workbook::Match path = workbook::search(svg, "<path stroke='rgb\\( *0, +75, 122\\)' +d='M([^']*)'");
    REQUIRE(path);
    return std::ranges::count(path[0], 'M');
  };
  CHECK(lines_of_student() == 2);
  course.solve("spring_energy");
  CHECK(lines_of_student() == 1);
}

TEST_CASE("a title that is wider than the picture takes two lines") {
  const CourseCopy course;
  auto results = workbook::read_reference_results(course.reference());
  results.exercises.at(1).sweep.title =
      "The force of a spring of 3 N/m that is stretched along x, while along y it stays stretched by 1 m";
  workbook::write_reference_results(results, course.reference());
  course.solve("spring_force");
  REQUIRE(course.run("plot spring_force --out pictures").status == 0);
  const std::string svg = read(course.root() / "pictures/spring_force.svg");
  CHECK(has(svg, "The force of a spring of 3 N/m that is stretched along x, while along y<"));
  CHECK(has(svg, "it stays stretched by 1 m<"));
}

TEST_CASE("chafa's graphics are shown, the size of the window; of its characters, and without it, we take letters") {
  const CourseToDraw course;
  const auto shown_with = [&](const std::string& chafa, const std::string& arguments, int columns = 80) {
    course.stand_in("bin/chafa", chafa);
    const TerminalOutcome outcome = course.run_on_terminal(
        arguments, columns, 24, "NO_COLOR=1 TERM=xterm PATH='" + course.root().string() + "/bin':\"$PATH\"");
    CHECK(has(outcome.shown, "spring_energy.png"));
    return outcome.shown;
  };
  for (const char* graphics : {"\\033_Ga=T", "\\033P0;1;0q", "\\033]1337;File="}) {
    const std::string shown = shown_with("printf '" + std::string(graphics) + "'; echo \" $*\"", plot, 60);
    CHECK_MESSAGE(has(shown, "--size 60x20 pictures/spring_energy.png"), shown);
    CHECK_FALSE(has(shown, letters_of_student));
  }
  for (const char* other : {"printf '\\033[0m\\033[7m'", "printf '\\033P'; exit 1", "printf ''"}) {
    const std::string shown = shown_with(other, plot);
    CHECK_MESSAGE(has(shown, letters_of_student), shown);
  }
  const std::string asked = "printf '\\033P'; touch asked";
  CHECK_FALSE(has(shown_with(asked, "--plain " + plot), letters_of_student));
  CHECK_FALSE(fs::exists(course.root() / "asked"));
}

TEST_CASE("letters are no wider than the terminal, and a line says what they mean") {
  const CourseToDraw course;
  for (const int columns : {30, 80, 160}) {
    CAPTURE(columns);
    const TerminalOutcome outcome = course.run_on_terminal(plot, columns, 40, "TERM=xterm-256color NO_COLOR=1");
    CHECK(outcome.status == 0);
    CHECK(has(outcome.shown, ".."));
    CHECK(has(outcome.shown, letters_of_student));
    std::string text = outcome.shown;
    std::erase(text, '\r');
    for (const std::string& line : lines_of(text)) CHECK_MESSAGE(display_width(line) <= columns, line);
  }
  const TerminalOutcome check = course.run_on_terminal("check spring_energy --plot", 80, 40, "TERM=xterm");
  CHECK(check.status == 1);
  CHECK(has(check.shown, letters_of_student));
}

TEST_CASE("a plot in letters; without a value, of the reference alone") {
  const CourseToDraw course;
  std::string shown;
  for (const std::string exercise : {"spring_energy", "spring_force"})
    shown += course.run_on_terminal("plot " + exercise + " --out pictures", 80, 24, "TERM=dumb").shown;
  std::erase(shown, '\r');
  check_golden("letters", shown);
}

TEST_CASE("each figure is tried on its own, and says what became of it" * doctest::test_suite("thorough")) {
  const CourseCopy course;
  give_figures(course);
  check_golden("figures", course.screens({"figures springs --out pictures --seconds 2"}));
  CHECK(read(course.root() / "pictures/sound.png").substr(1, 3) == "PNG");
  CHECK_FALSE(fs::exists(course.root() / "pictures/not_finite.svg"));
  CHECK_FALSE(fs::exists(course.root() / "pictures/sound.svg.complete"));
  // Of two lines the ball hides the middle of one.
  const std::string ball = read(course.root() / "pictures/ball.svg");
  CHECK(has(ball, ">1.234 m<"));
  CHECK(has(ball, "data:image/png;base64,"));
  const workbook::Match faint = workbook::search(ball, "opacity='0.3'  d='M([\\d.]+),[\\d.]+ ([\\d.]+),[\\d.]+ *'");
  REQUIRE(faint);
  CHECK(std::stod(faint[1]) == doctest::Approx(160 - 76).epsilon(0.01));
  CHECK(std::stod(faint[2]) == doctest::Approx(160 + 76).epsilon(0.01));
}

TEST_CASE("figures that cannot be built or listed say why") { CourseCopy().check_story("figures_not_drawn"); }

TEST_CASE("live figures take the functions that pass, and say where one of them is needed") {
  CourseCopy().check_story("live");
}

TEST_CASE("the program of the figures refuses a name that it does not know, and ends badly if a figure does" *
          doctest::test_suite("thorough")) {
  const CourseCopy course;
  const auto status = [&](const std::string& arguments) {
    return run_in_shell("cd '" + course.root().string() + "' && '" WORKBOOK_TEST_FIGURES "' " + arguments +
                        " >said 2>&1");
  };
  CHECK(status("pictures sound") == 0);
  CHECK(status("pictures idle") == 3);
  CHECK(status("pictures refused") == 1);
  CHECK(status("pictures left_handed") == 1);
  CHECK(read(course.root() / "said").starts_with("drawn\nleft_handed: "));  // the right-handed axes, not the others
  CHECK(status("pictures no_such_figure") == 2);
  CHECK(status("") == 2);
}

TEST_CASE("each worked example says whether it holds, what it needs, or which check failed with both numbers") {
  const CourseCopy course;
  const std::string success = "<OverallResultsAsserts test_case_success=\"true\"/>";
  const std::string failure = "<OverallResultsAsserts test_case_success=\"false\"/>";
  const std::string place =
      " success=\"false\" type=\"CHECK\" filename=\"/w/lectures/01_springs/worked_examples.cpp\" ";
  const auto report = [](const std::string& cases) {
    return "cat <<'END'\n<?xml version=\"1.0\"?><doctest><TestSuite>" + cases + "</TestSuite></doctest>\nEND";
  };
  const auto example = [](const std::string& name, const std::string& content) {
    return "<TestCase name=\"" + name + "\">" + content + "</TestCase>";
  };
  std::string screens = examples(
      course, "true",
      report(
          example("A spring stores energy", success) +
          example("A spring pulls back", "<Exception crash=\"false\">not started: spring_force</Exception>" + failure) +
          example("Energy from force", "<Expression" + place +
                                           "line=\"8\"><Original> agrees(work(k), E) </Original><Exception>not "
                                           "started: spring_force</Exception></Expression>" +
                                           failure) +
          example("A spring swings", "<Expression" + place +
                                         "line=\"12\"><Original> agrees(T, 3.2) </Original><Expanded> 7.1 where "
                                         "3.2 is expected (difference 3.9, allowed 1e-12) </Expanded></Expression>" +
                                         failure)));
  screens += examples(course, "true", report(example("A spring stores energy", success)));
  screens += examples(course, failed_build, "true");
  for (const char* run : {"kill -SEGV $$", "echo '<mine'; exit 4", "true", "head -c 9000000 /dev/zero"})
    screens += examples(course, "true", run);
  check_golden("examples", screens);
  CHECK(examples(course, "rm build/build.log; exit 1", "true").ends_with("[3]\n\n"));
}

TEST_CASE("plot --all draws every overlay and brings the figures of every lecture, or says what is missing") {
  CourseCopy().check_story("plot_all");
}
