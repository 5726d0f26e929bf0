/// @file
/// The plot: the student's curve on the reference results, and the difference below.
#pragma once

#include "checker/base/console.hpp"
#include "checker/base/text.hpp"
#include "checker/pipeline/check_exercise.hpp"

#include <limits>

namespace workbook {

inline constexpr const char* gnuplot_is_missing =
    "gnuplot is not installed (on Debian: apt-get install gnuplot-nox), so there are no plots and figures; everything "
    "else works without it.";

/// One curve per component of the result. Where there is no value, there is NaN.
struct Overlay {
  using Curves = std::vector<std::vector<double>>;

  const Sweep* sweep = nullptr;
  std::vector<std::string> labels;  ///< of the components: "E", or "|E|" where the sign is free
  Curves reference;
  Curves student;                  ///< empty: no value at all
  Curves misconception;            ///< empty: none is recognised
  std::string misconception_name;  ///< "no half"
  /// The smallest step that no line may join: an angle that starts again at −π, a whole number that changes.
  double jump = std::numeric_limits<double>::infinity();
  bool has_whole_numbers = false;
  bool has_turns = false;  ///< angles that differ by full turns are one attitude
};

/// Runs the student's function along the sweep.
/// @throws std::runtime_error if there is no sweep, LaunchError or SandboxError if the worker cannot be started
Overlay overlay_of(const CheckResult& checked);

/// Where plots lie unless another place is asked for.
fs::path plots_directory(const Course& course);

/// Draws DIRECTORY/NAME.svg and DIRECTORY/NAME.png. Returns both paths.
/// @throws std::runtime_error if gnuplot is missing, the folder cannot be written, or gnuplot fails
std::vector<fs::path> draw_overlay(const Overlay& overlay, const fs::path& directory, const std::string& name);

/// What gnuplot draws on a terminal of the given name and options: the curves, and below them the difference.
/// @param directory  for files on the way
/// @throws std::runtime_error
std::string drawn_overlay(const Overlay& overlay, const std::string& terminal, const fs::path& directory);

/// The curves alone, made of letters on such a terminal, and what the letters mean.
std::string drawn_letters(const Overlay& overlay, const std::string& terminal, std::size_t columns,
                          const fs::path& directory);
std::string meaning_of_letters(const Overlay& overlay);

// --- on the terminal itself, in the best way that it can show

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
/// @throws std::runtime_error
std::string terminal_picture(PictureKind kind, const Overlay& overlay, const fs::path& png, const Console& console);

}  // namespace workbook
