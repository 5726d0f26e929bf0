// Plots on the terminal: the right kind for each terminal, legible, and nothing where nobody looks.
#include "checker/base/base64.hpp"
#include "checker/report/terminal_graphics.hpp"
#include "checker/report/terminal_picture.hpp"
#include "tests/program/program.hpp"
#include "tests/program/terminal.hpp"

#include <doctest/doctest.h>

#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <regex>
#include <sstream>

using namespace workbook;
using namespace workbook::testing;

namespace {

const char* const kitty_and_attributes = "\033_Gi=31;OK\033\\\033[?62;c";
const char* const sixel_attributes = "\033[?62;4;22c";
const char* const no_graphics = "\033[?1;2c";

std::string from_base64(std::string text) {
  using namespace boost::archive::iterators;
  using Bytes = transform_width<binary_from_base64<std::string::const_iterator>, 8, 6>;
  const auto padding = static_cast<std::size_t>(std::count(text.begin(), text.end(), '='));
  std::replace(text.begin(), text.end(), '=', 'A');
  std::string bytes(Bytes(text.cbegin()), Bytes(text.cend()));
  bytes.resize(bytes.size() - padding);
  return bytes;
}

/// The picture in the escape sequences of kitty's protocol.
std::string picture_in(const std::string& shown) {
  std::string text;
  const std::regex chunk("\033_G([^;\033]*m=([01]));([A-Za-z0-9+/=]*)\033\\\\");
  for (std::sregex_iterator match(shown.begin(), shown.end(), chunk), end; match != end; ++match) {
    CHECK((*match)[3].length() <= 4096);
    text += (*match)[3];
    if ((*match)[2] == "0") break;
  }
  return from_base64(text);
}

TerminalTraits watched(const std::string& term) {
  TerminalTraits traits;
  traits.is_watched = true;
  traits.term = term;
  return traits;
}

GraphicsAnswer never_asked() {
  FAIL("the terminal must not be asked here");
  return {};
}

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, display_width(line));
  return widest;
}

}  // namespace

TEST_CASE("base64 has the known values, for every number of bytes left over") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64(std::string("\0\xff\x80", 3)) == "AP+A");
}

TEST_CASE("kitty's escape sequences hold the whole picture in chunks of at most 4096 letters") {
  for (const std::size_t size : {1, 3071, 3072, 3073, 10000}) {
    CAPTURE(size);
    std::string picture;
    for (std::size_t i = 0; i < size; ++i) picture += static_cast<char>(i * 37 % 251);
    const std::string text = kitty_picture(picture, 60);
    CHECK(text.starts_with("\033_Ga=T,f=100,q=2,c=60,"));
    CHECK(picture_in(text) == picture);
  }
}

TEST_CASE("a terminal's answer is read for kitty's protocol and for sixel") {
  CHECK(read_graphics_answer(kitty_and_attributes).kitty);
  CHECK_FALSE(read_graphics_answer(kitty_and_attributes).sixel);
  CHECK(read_graphics_answer(sixel_attributes).sixel);
  CHECK(read_graphics_answer("\033[?62;1;4c").sixel);
  CHECK_FALSE(read_graphics_answer(no_graphics).sixel);
  CHECK_FALSE(read_graphics_answer("\033[?4;6c").sixel);    // a VT132, no attribute
  CHECK_FALSE(read_graphics_answer("\033[?62;14c").sixel);  // another attribute
  CHECK_FALSE(read_graphics_answer("\033_Gi=31;ENOTSUPPORTED\033\\\033[?62c").kitty);
  CHECK_FALSE(read_graphics_answer("").kitty);
}

TEST_CASE("the kind of picture follows the wish, then the terminal") {
  const auto says_kitty = [] { return GraphicsAnswer{true, true}; };
  const auto says_sixel = [] { return GraphicsAnswer{false, true}; };
  const auto says_nothing = [] { return GraphicsAnswer{}; };
  const TerminalTraits xterm = watched("xterm-256color");
  CHECK(choose_picture(PictureKind::automatic, 1, xterm, says_kitty) == PictureKind::kitty);
  CHECK(choose_picture(PictureKind::automatic, 1, xterm, says_sixel) == PictureKind::sixel);
  CHECK(choose_picture(PictureKind::automatic, 1, xterm, says_nothing) == PictureKind::text);
  CHECK(choose_picture(PictureKind::automatic, 2, xterm, never_asked) == PictureKind::none);
  CHECK(choose_picture(PictureKind::text, 2, {}, never_asked) == PictureKind::text);
  CHECK(choose_picture(PictureKind::none, 1, xterm, never_asked) == PictureKind::none);
  CHECK(choose_picture(PictureKind::automatic, 1, watched("dumb"), never_asked) == PictureKind::text);
  CHECK(choose_picture(PictureKind::automatic, 1, watched("xterm-kitty"), never_asked) == PictureKind::kitty);
  TerminalTraits inherited = watched("tmux-256color");
  inherited.has_kitty_window = true;
  inherited.is_multiplexed = true;
  CHECK(choose_picture(PictureKind::automatic, 1, inherited, says_nothing) == PictureKind::text);
  TerminalTraits plain = xterm;
  plain.is_plain = true;
  CHECK(choose_picture(PictureKind::automatic, 1, plain, never_asked) == PictureKind::none);
  CHECK(choose_picture(PictureKind::automatic, 1, {}, never_asked) == PictureKind::none);
}

TEST_CASE("a terminal of kitty's kind gets the very picture that lies in the folder") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  const TerminalOutcome outcome = run_on_terminal(course, {"plot", "spring_energy", "--out", "pictures"},
                                                  {.answer = kitty_and_attributes}, {"TERM=xterm-256color"});
  CHECK(outcome.status == 0);
  CHECK(outcome.was_asked);
  CHECK(outcome.echoes_afterwards);
  CHECK(picture_in(outcome.shown) == read(course.root() / "pictures/spring_energy.png"));
  CHECK(has(outcome.shown, "pictures/spring_energy.svg"));
}

TEST_CASE("a terminal with sixel gets sixel, no larger than its window") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  const TerminalOutcome outcome =
      run_on_terminal(course, {"plot", "spring_energy", "--out", "pictures"},
                      {.columns = 60, .rows = 24, .answer = sixel_attributes}, {"TERM=xterm"});
  CHECK(outcome.status == 0);
  std::smatch size;
  const std::regex raster("\033P[0-9;]*q\"[0-9]+;[0-9]+;([0-9]+);([0-9]+)");
  REQUIRE(std::regex_search(outcome.shown, size, raster));
  CHECK(std::stoi(size[1]) <= 60 * 8);
  CHECK(std::stoi(size[2]) <= 24 * 16);
  CHECK(has(outcome.shown, "\033\\"));
}

TEST_CASE("any other terminal gets letters, and a line that says what they mean") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  for (const int columns : {30, 80, 160}) {
    CAPTURE(columns);
    const TerminalOutcome outcome =
        run_on_terminal(course, {"plot", "spring_energy", "--out", "pictures"},
                        {.columns = columns, .answer = no_graphics}, {"TERM=xterm-256color", "NO_COLOR=1"});
    CHECK(outcome.status == 0);
    CHECK(has(outcome.shown, "A"));
    CHECK(has(outcome.shown, "..."));
    if (columns >= 80)
      CHECK_MESSAGE(has(outcome.shown, "A your E, . its reference; ~ what “no half” would give"), outcome.shown);
    const std::size_t asked = outcome.shown.find("\033[c") + 3;
    CHECK(widest_line(std::regex_replace(outcome.shown.substr(asked), std::regex("\r"), "")) <=
          static_cast<std::size_t>(columns));
  }
}

TEST_CASE("a terminal that keeps silent gets letters after a moment, and one that was typed on is not asked") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  const std::vector<std::string> arguments = {"plot", "spring_energy", "--out", "pictures"};
  const TerminalOutcome silent = run_on_terminal(course, arguments, {}, {"TERM=xterm"});
  CHECK(silent.was_asked);
  CHECK(silent.echoes_afterwards);
  CHECK(has(silent.shown, "A your E"));
  const TerminalOutcome typed = run_on_terminal(course, arguments, {.typed_ahead = "ls\n"}, {"TERM=xterm"});
  CHECK_FALSE(typed.was_asked);
  CHECK(has(typed.shown, "A your E"));
}

TEST_CASE("the plain mode and --picture none show no picture, and ask nothing") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  const TerminalOutcome plain = run_on_terminal(course, {"plot", "spring_energy", "--out", "pictures"},
                                                {.answer = kitty_and_attributes}, {"TERM=xterm", "WORKBOOK_PLAIN=1"});
  const TerminalOutcome none =
      run_on_terminal(course, {"plot", "spring_energy", "--out", "pictures", "--picture", "none"},
                      {.answer = kitty_and_attributes}, {"TERM=xterm"});
  for (const TerminalOutcome& outcome : {plain, none}) {
    CHECK(outcome.status == 0);
    CHECK_FALSE(outcome.was_asked);
    CHECK_FALSE(has(outcome.shown, "A your E"));
    CHECK(has(outcome.shown, "spring_energy.png"));
  }
}

TEST_CASE("check --plot shows the same picture, and changes no verdict") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  const TerminalOutcome outcome = run_on_terminal(course, {"check", "spring_energy", "--plot"}, {.answer = no_graphics},
                                                  {"TERM=xterm", "NO_COLOR=1"});
  CHECK(outcome.status == 1);
  CHECK(has(outcome.shown, "A your E, . its reference"));
  CHECK(has(outcome.shown, "wrong value"));
}

TEST_CASE("output that is no terminal gets the paths alone, unless a kind is named") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  CHECK(course.run("plot spring_energy --out pictures").out ==
        "pictures/spring_energy.svg\npictures/spring_energy.png\n");
  const Outcome letters = course.run("plot springs --out pictures --picture text");
  CHECK_MESSAGE(has(letters.out, "A your E, . its reference"), letters.out);
  CHECK_MESSAGE(has(letters.out, ". the reference of F_x; : the reference of F_y"), letters.out);
  CHECK(has(letters.out, "only the reference is drawn"));
  CHECK_FALSE(has(letters.out, "\033"));
  const Outcome wrong = course.run("plot spring_energy --picture oil");
  CHECK(wrong.status == 2);
}

TEST_CASE("values that no picture can hold leave no half picture, and the verdict stands") {
  const CourseCopy course;
  course.answer_energy("return 1.7e308;");
  const Outcome outcome = course.run("plot spring_energy --out pictures");
  CHECK(outcome.status == 3);
  CHECK_MESSAGE(has(outcome.err, "gnuplot could not draw pictures/spring_energy.svg: perhaps the values are too large"),
                outcome.err);
  CHECK(std::filesystem::is_empty(course.root() / "pictures"));
  const Outcome check = course.run("check spring_energy --plot");
  CHECK(check.status == 1);
  CHECK(has(check.err, "the verdict stands without it"));
}
