/// @file
/// Which pictures the terminal can show. No option of ours decides that: the terminal is asked.
#pragma once

#include "checker/report/console.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace workbook {

/// A way to show a picture on the terminal.
enum class PictureKind {
  automatic,  ///< the best that the terminal can do; none where nobody looks at it
  kitty,      ///< the graphics protocol of kitty, Ghostty, WezTerm, Konsole
  sixel,      ///< the graphics of DEC's terminals: xterm, foot, mlterm, Windows Terminal
  text,       ///< a drawing made of letters
  none
};

/// What the terminal says of itself.
struct GraphicsAnswer {
  bool kitty = false;
  bool sixel = false;
};

/// What is known without asking.
struct TerminalTraits {
  bool is_watched = false;  ///< standard input and output are one terminal, and we have its attention
  bool is_plain = false;    ///< no drawings wanted
  std::string term;         ///< the variable TERM
  std::string term_program;
  bool has_kitty_window = false;
  bool is_multiplexed = false;  ///< tmux or screen stands between us and the terminal, and has its own answer
};

TerminalTraits traits_of_this_terminal(const Console& console);

/// Reads the answers to both questions out of whatever came back: kitty's, and the primary device attributes, where 4
/// means sixel.
GraphicsAnswer read_graphics_answer(std::string_view reply);

/// Asks the terminal behind standard input and output, and waits at most 0.2 s. Says nothing if somebody has typed
/// ahead: those letters belong to the shell.
GraphicsAnswer ask_terminal();

/// The kind to draw; never `automatic`. Of several plots nothing is shown unless a kind was named: they would chase
/// each other off the screen. `ask` is called only where it matters.
PictureKind choose_picture(PictureKind wanted, std::size_t plots, const TerminalTraits& traits,
                           const std::function<GraphicsAnswer()>& ask = ask_terminal);

/// The place for a picture, so that the whole of it is seen at once.
struct PictureSpace {
  std::size_t columns = 80;
  std::size_t rows = 24;
  std::size_t cell_width = 8;    ///< in pixels
  std::size_t cell_height = 16;  ///< in pixels
};

PictureSpace picture_space(const Console& console);

}  // namespace workbook
