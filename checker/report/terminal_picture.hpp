/// @file
/// A plot on the terminal itself, in the best way that the terminal can show.
#pragma once

#include "checker/base/console.hpp"
#include "checker/report/overlay.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace workbook {

enum class PictureKind {
  automatic,  ///< the best that the terminal can show; none where nobody looks at it
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

/// Reads the answers to both questions out of whatever came back: kitty's, and the primary device attributes, where 4
/// means sixel.
GraphicsAnswer read_graphics_answer(std::string_view reply);

/// Asks the terminal behind standard input and output, and waits at most 0.2 s. Does not ask if somebody has typed
/// ahead: those letters belong to the shell.
GraphicsAnswer ask_terminal();

/// What is known without asking.
struct TerminalTraits {
  bool is_watched = false;  ///< standard input and output are one terminal, and we are in its foreground
  bool is_plain = false;    ///< no drawings wanted
  std::string term;         ///< the variable TERM
  std::string term_program;
  bool has_kitty_window = false;
  bool is_multiplexed = false;  ///< tmux or screen stands between us and the terminal, and has its own answer
};
TerminalTraits traits_of_this_terminal(const Console& console);

/// The kind to draw; never `automatic`. Of several plots nothing is shown unless a kind was named: they would chase
/// each other off the screen. `ask` is called only where it matters.
PictureKind choose_picture(PictureKind wanted, std::size_t plots, const TerminalTraits& traits,
                           const std::function<GraphicsAnswer()>& ask = ask_terminal);

/// What makes a terminal of kitty's kind show a PNG, that many columns wide.
std::string kitty_picture(std::string_view png, std::size_t columns);

/// What to print for the plot to be seen, no larger than the window; "" for `none`.
/// @param png  what draw_overlay() has left
/// @throws PlotError
std::string terminal_picture(PictureKind kind, const Overlay& overlay, const std::filesystem::path& png,
                             const Console& console);

}  // namespace workbook
