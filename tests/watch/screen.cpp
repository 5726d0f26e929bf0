// The pure parts of the watch: what is a key, and what fits on a screen.
#include "checker/base/text.hpp"
#include "checker/commands/watch/watch.hpp"
#include "tests/support/files.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace workbook;
using workbook::testing::has;
using Texts = std::vector<std::string>;

namespace {

Texts keys_of(std::string typed) { return take_keys(typed); }

Scene scene(std::size_t lines) {
  Scene scene{.lecture = "01_springs",
              .exercise = "spring_energy",
              .passed = 1,
              .total = 2,
              .body = "",
              .state = "",
              .idle = "idle",
              .keys = "h:hint q:quit",
              .first_row = 0};
  for (std::size_t i = 1; i <= lines; ++i) scene.body += "line " + std::to_string(i) + "\n";
  return scene;
}

std::size_t visible_width(std::string row) {
  for (std::size_t at = row.find('\033'); at != std::string::npos; at = row.find('\033'))
    row.erase(at, row.find('m', at) + 1 - at);
  return display_width(row);
}

}  // namespace

TEST_CASE("keys come one by one, as small letters, and no part of a sequence is a letter") {
  CHECK(keys_of("hQ\x03") == Texts{"h", "q", "\x03"});
  CHECK(keys_of("\033[A\033OB\033[6~j") == Texts{"\033[A", "\033OB", "\033[6~", "j"});
  CHECK(keys_of("ö\t\xff") == Texts{"ö", "\t", "\xff"});
  CHECK(keys_of("\033[15~\033h\033") == Texts{"\033[15~", "\033h", "\033"});  // F5, Alt-h, the escape key
  std::string typed = "\033[";                                                // the rest is still to come
  CHECK(take_keys(typed).empty());
  typed += "Bq";
  CHECK(take_keys(typed) == Texts{"\033[B", "q"});
}

TEST_CASE("long lines are folded, and a colour goes on in the next row") {
  CHECK(folded("a_long_name", 6) == Texts{"a_long", "_name"});
  CHECK(folded("one\n\ntwo\n", 8) == Texts{"one", "", "two"});
  CHECK(folded("", 8).empty());
  CHECK(folded("½½½½½½½", 5) == Texts{"½½½½½", "½½"});
  CHECK(folded("\033[1mbold\nstill\033[0m\nnot", 9) == Texts{"\033[1mbold\033[0m", "\033[1mstill\033[0m", "not"});
  CHECK(folded("\033[1mbold\033[0m", 2) == Texts{"\033[1mbo\033[0m", "\033[1mld\033[0m"});
  CHECK(folded("a\033[2Jb\rc\x7f\td", 20) == Texts{"a?[2Jb?c? d"});  // nothing steers the terminal
}

TEST_CASE("a link takes the room of its text, is closed at the end of a row and goes on in the next") {
  const std::string text = Console(80, true, false, true).linked("notes", "file:///n.html");
  const std::string begin = "\033]8;;file:///n.html\033\\", end = "\033]8;;\033\\";
  CHECK(text == begin + "notes" + end);
  CHECK(folded("a " + text + " b", 9) == Texts{"a " + text + " b"});
  CHECK(folded(text, 3) == Texts{begin + "not" + end, begin + "es" + end});
  CHECK(folded("\033]8;;cut", 20) == Texts{"?]8;;cut"});
  for (const Console& console : {Console(), Console(80, true), Console(80, true, true, true)})
    CHECK(console.linked("notes", "file:///n.html") == "file:///n.html");
}

TEST_CASE("the screen is never taller or wider than the terminal") {
  const Console console(30, true);
  for (std::size_t columns = 1; columns < 60; columns += 3) {
    for (std::size_t rows = 1; rows < 30; ++rows) {
      for (const std::size_t lines : {0, 1, 5, 100}) {
        const Layout layout = lay_out(scene(lines), {columns, rows}, console);
        CAPTURE(columns);
        CAPTURE(lines);
        CHECK(layout.rows.size() == rows);
        CHECK(layout.end_of_body <= rows);
        for (const std::string& row : layout.rows) CHECK(visible_width(row) <= columns);
      }
    }
  }
}

TEST_CASE("a body that fits leaves a line for what the watch waits for; one that does not can be scrolled") {
  Layout layout = lay_out(scene(3), {80, 10}, Console());
  CHECK(has(layout.rows[0], "01_springs › spring_energy"));
  CHECK(layout.rows[0].ends_with("1 of 2"));
  CHECK(layout.rows[2] == "line 1");
  CHECK(layout.rows[8] == "idle");
  CHECK(layout.rows[9] == "h:hint q:quit");
  Scene tall = scene(50);
  layout = lay_out(tall, {80, 14}, Console());
  CHECK(layout.rows[2] == "line 1");
  CHECK(has(layout.rows[12], "1–10 of 50"));
  tall.first_row = 1000;
  layout = lay_out(tall, {80, 14}, Console());
  CHECK(layout.first_row == 40);
  CHECK(layout.rows[11] == "line 50");
  CHECK(has(layout.rows[12], "41–50 of 50"));
  tall.state = "checking";
  CHECK(lay_out(tall, {80, 14}, Console()).rows[12] == "checking");
}

TEST_CASE("a narrow screen keeps the exercise and the count before the lecture and the bar") {
  CHECK(lay_out(scene(1), {26, 10}, Console()).rows[0] == "spring_energy       1 of 2");
  CHECK(lay_out(scene(1), {10, 10}, Console()).rows[0] == "spring_en…");
}
