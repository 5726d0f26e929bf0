/// @file
/// What the watch shows, laid out for a terminal of a given size. Pure text: nothing here writes to a terminal.
#pragma once

#include "checker/base/console.hpp"
#include "checker/watch/terminal.hpp"

namespace workbook {

/// What is to be seen. Body and state may hold colours and lines that are too long.
struct Scene {
  std::string lecture;  ///< of the current exercise
  std::string exercise;
  std::size_t passed = 0;  ///< of all exercises, for the bar
  std::size_t total = 0;
  std::string body;           ///< verdicts, hints: as long as they like
  std::string state;          ///< one line: what goes on; "" if nothing does
  std::string idle;           ///< in its place then, if the whole body is to be seen
  std::string keys;           ///< what can be pressed
  std::size_t first_row = 0;  ///< of the body, for scrolling
};

/// The rows of the terminal, from its top to its last.
struct Layout {
  std::vector<std::string> rows;
  std::size_t end_of_body = 0;  ///< how many rows are heading and body
  std::size_t body_shown = 0;   ///< rows of the body that fit
  std::size_t first_row = 0;    ///< of the body, corrected if it was too far
};

/// Never more rows than the terminal has, none wider than it is. What does not fit is announced in the state's line.
Layout lay_out(const Scene& scene, TerminalSize size, const Console& console);

/// The text as rows of at most `width` columns. A colour that is on at the end of a row goes on in the next; other
/// control characters become "?".
std::vector<std::string> folded(const std::string& text, std::size_t width);

}  // namespace workbook
