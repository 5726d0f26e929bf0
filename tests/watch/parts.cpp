// The pure parts of the watch: what keys mean, and what fits on a screen.
#include "checker/watch/keys.hpp"
#include "checker/watch/screen.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace workbook;
using workbook::testing::has;

namespace {

std::vector<Action> actions(const std::string& bytes) {
  KeyReader reader;
  std::vector<Action> result;
  for (const Key& key : reader.read(bytes)) result.push_back(key.action);
  return result;
}

Scene scene(std::size_t lines) {
  Scene scene;
  scene.lecture = "01_springs";
  scene.exercise = "spring_energy";
  scene.passed = 1;
  scene.total = 2;
  for (std::size_t i = 1; i <= lines; ++i) scene.body += "line " + std::to_string(i) + "\n";
  scene.idle = "nothing to do";
  scene.keys = {"h hint", "q quit"};
  return scene;
}

std::size_t visible_width(std::string row) {
  for (std::size_t at = row.find('\033'); at != std::string::npos; at = row.find('\033'))
    row.erase(at, row.find('m', at) + 1 - at);
  return display_width(row);
}

}  // namespace

TEST_CASE("keys are understood one by one, small or capital") {
  using enum Action;
  CHECK(actions("hlpnbcrq") == std::vector{hint, list, plot, next, back, compiler, again, quit});
  CHECK(actions("HQ") == std::vector{hint, quit});
  CHECK(actions("\x03\x04") == std::vector{quit, quit});
  CHECK(actions("\033[A\033[B\033OA\033OB\033[5~\033[6~ jk") ==
        std::vector{up, down, up, down, page_up, page_down, page_down, down, up});
}

TEST_CASE("a key that means nothing is named, and no part of it is taken for another key") {
  KeyReader reader;
  CHECK(reader.read("x") == std::vector{Key{Action::unknown, "x"}});
  CHECK(reader.read("ö") == std::vector{Key{Action::unknown, "ö"}});
  CHECK(reader.read("\t") == std::vector{Key{Action::unknown, ""}});
  CHECK(reader.read("\033[15~") == std::vector{Key{Action::unknown, ""}});  // F5: no "1", no "5"
  CHECK(reader.read("\033h") == std::vector{Key{Action::unknown, ""}});     // Alt-h
  CHECK(reader.read("\033") == std::vector{Key{Action::unknown, ""}});
  CHECK(reader.read("\xff") == std::vector{Key{Action::unknown, ""}});
}

TEST_CASE("a key whose bytes arrive in two parts is one key") {
  KeyReader reader;
  CHECK(reader.read("\033[").empty());
  CHECK(reader.read("Bq") == std::vector{Key{Action::down, ""}, Key{Action::quit, "q"}});
}

TEST_CASE("long lines are folded between words, and a colour goes on in the next row") {
  CHECK(folded("one two three", 8) == std::vector<std::string>{"one two", "three"});
  CHECK(folded("a_very_long_name", 8) == std::vector<std::string>{"a_very_l", "ong_name"});
  CHECK(folded("one\n\ntwo\n", 8) == std::vector<std::string>{"one", "", "two"});
  CHECK(folded("", 8).empty());
  CHECK(folded("½½½½½½½½½½", 5) == std::vector<std::string>{"½½½½½", "½½½½½"});
  CHECK(folded("\033[1mbold words\033[0m here", 5) ==
        std::vector<std::string>{"\033[1mbold\033[0m", "\033[1mwords\033[0m", "here"});
  CHECK(folded("\033[1mbold\nstill\033[0m\nnot", 9) ==
        std::vector<std::string>{"\033[1mbold\033[0m", "\033[1mstill\033[0m", "not"});
}

TEST_CASE("what would steer the terminal is made harmless, and tabs are spaces") {
  CHECK(folded("a\033[2Jb", 20) == std::vector<std::string>{"a?[2Jb"});
  CHECK(folded("a\rb\x7f", 20) == std::vector<std::string>{"a?b?"});
  CHECK(folded("a\tb", 20) == std::vector<std::string>{"a   b"});
}

TEST_CASE("the screen is never taller or wider than the terminal") {
  const Console console(30, true);
  for (std::size_t columns = 1; columns < 60; columns += 3) {
    for (std::size_t rows = 1; rows < 30; ++rows) {
      for (const std::size_t lines : {0, 1, 5, 100}) {
        const Layout layout = lay_out(scene(lines), {columns, rows}, console);
        CAPTURE(columns);
        CAPTURE(rows);
        CAPTURE(lines);
        CHECK(layout.rows.size() == rows);
        CHECK(layout.end_of_body <= rows);
        for (const std::string& row : layout.rows) CHECK(visible_width(row) <= columns);
      }
    }
  }
}

TEST_CASE("a body that fits leaves room for what the watch waits for") {
  const Layout layout = lay_out(scene(3), {80, 10}, Console());
  CHECK(has(layout.rows[0], "01_springs › spring_energy"));
  CHECK(layout.rows[0].ends_with("1 of 2"));
  CHECK(layout.rows[2] == "line 1");
  CHECK(layout.rows[8] == "nothing to do");
  CHECK(layout.rows[9] == "h hint · q quit");
}

TEST_CASE("a body that is too long can be scrolled, and says so") {
  Scene long_one = scene(50);
  Layout layout = lay_out(long_one, {80, 14}, Console());
  CHECK(layout.rows[2] == "line 1");
  CHECK(layout.rows[12] == "Lines 1–10 of 50: space or ↓ shows more");
  long_one.first_row = 1000;
  layout = lay_out(long_one, {80, 14}, Console());
  CHECK(layout.first_row == 40);
  CHECK(layout.rows[11] == "line 50");
  CHECK(layout.rows[12] == "Lines 41–50 of 50: ↑ goes back up");
  long_one.state = "checking";
  CHECK(lay_out(long_one, {80, 14}, Console()).rows[12] == "checking");
}

TEST_CASE("a narrow screen keeps the exercise and the count before the lecture and the bar") {
  CHECK(lay_out(scene(1), {26, 10}, Console()).rows[0] == "spring_energy       1 of 2");
  CHECK(lay_out(scene(1), {10, 10}, Console()).rows[0] == "spring_en…");
}
