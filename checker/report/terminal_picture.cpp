#include "checker/report/reports.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

namespace workbook {

namespace {

constexpr std::chrono::milliseconds patience{200};
constexpr char interrupt_key = '\003';

/// One pixel, only tried; then the device attributes, which every terminal answers: so we need not wait for a "no".
constexpr std::string_view graphics_query = "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\\033[c";

constexpr double aspect_ratio = 1.25;        // width over height of the drawn pictures
constexpr std::size_t widest_picture = 100;  // in columns; larger ones show no more
constexpr std::size_t rows_for_text = 4;     // the paths and the next prompt stay in sight

/// Lets single letters through, unechoed, as long as it lives.
struct UnbufferedInput {
  UnbufferedInput() : changed(tcgetattr(STDIN_FILENO, &before) == 0) {
    termios raw = before;
    // Without the interrupt key as well: a process that ends here would leave the terminal without echo.
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
    raw.c_cc[VMIN] = raw.c_cc[VTIME] = 0;
    changed = changed && tcsetattr(STDIN_FILENO, TCSADRAIN, &raw) == 0;
  }
  ~UnbufferedInput() {
    if (changed) tcsetattr(STDIN_FILENO, TCSADRAIN, &before);
  }
  UnbufferedInput(const UnbufferedInput&) = delete;
  UnbufferedInput& operator=(const UnbufferedInput&) = delete;

  termios before{};
  bool changed;
};

bool has_input(Clock::time_point deadline) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, milliseconds_until(deadline)) == 1 && (input.revents & POLLIN) != 0;
}

/// "62;4;22;" from "\033[?62;4;22c"; "" if it has not come.
std::string device_attributes(std::string_view reply) {
  const std::size_t begin = std::min(reply.find("\033[?"), reply.size());
  const std::string_view answer = reply.substr(std::min(begin + 3, reply.size()));
  const std::size_t length = answer.find_first_not_of("0123456789;");
  return length == std::string_view::npos || answer[length] != 'c' ? "" : std::string(answer.substr(0, length)) + ";";
}

/// Everything up to the end of the second answer, or what came in time.
std::string question_and_answer() {
  std::string reply;
  const UnbufferedInput input;
  if (!input.changed || has_input(Clock::now())) return reply;
  if (write(STDOUT_FILENO, graphics_query.data(), graphics_query.size()) != static_cast<ssize_t>(graphics_query.size()))
    return reply;
  const Clock::time_point deadline = Clock::now() + patience;
  while (device_attributes(reply).empty() && reply.find(interrupt_key) == std::string::npos) {
    if (!has_input(deadline)) break;
    char letters[256];
    const ssize_t count = read(STDIN_FILENO, letters, sizeof letters);
    if (count <= 0) break;
    reply.append(letters, static_cast<std::size_t>(count));
  }
  return reply;
}

/// The place for a picture, so that the whole of it is seen at once.
struct Space {
  std::size_t rows = 24 - rows_for_text;
  std::size_t columns = 80;
  std::size_t cell_width = 8;    // in pixels
  std::size_t cell_height = 16;  // in pixels
};

Space space_on(const Console& console) {
  Space space;
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0 && size.ws_col > 0) {
    space.rows = std::max<std::size_t>(10, size.ws_row - std::min<std::size_t>(size.ws_row, rows_for_text));
    if (size.ws_xpixel >= size.ws_col && size.ws_ypixel >= size.ws_row) {
      space.cell_width = size.ws_xpixel / size.ws_col;
      space.cell_height = size.ws_ypixel / size.ws_row;
    }
  }
  const auto highest = aspect_ratio * static_cast<double>(space.rows * space.cell_height);
  space.columns = std::min(
      {static_cast<std::size_t>(highest / static_cast<double>(space.cell_width)), console.width(), widest_picture});
  return space;
}

std::string sixel_picture(const Overlay& overlay, const fs::path& directory, const Space& space) {
  const std::size_t width = space.columns * space.cell_width;
  // Letters and lines shrink with the picture, as far as they can be read.
  const double scale = std::clamp(static_cast<double>(width) / 800.0, 0.6, 1.5);
  return drawn_overlay(
      overlay,
      fmt::format("sixelgd noenhanced truecolor size {},{:.0f} font 'Helvetica,{:.0f}' linewidth {:.1f} background rgb "
                  "'white'",
                  width, static_cast<double>(width) / aspect_ratio, 11 * scale, scale),
      directory);
}

std::string letter_picture(const Overlay& overlay, const fs::path& directory, const Console& console) {
  const std::size_t columns = std::min(console.width(), widest_picture) - 1;
  const std::size_t rows = std::clamp<std::size_t>(space_on(console).rows, 12, 28);
  const std::string terminal =
      fmt::format("dumb noenhanced size {},{} {}", columns, rows, console.color() ? "ansi256" : "mono");
  const std::string drawing = drawn_letters(overlay, terminal, columns, directory);
  std::string text;
  for (std::string line : lines_of(drawing)) {
    std::erase(line, '\f');  // gnuplot begins with a new page
    line.erase(line.find_last_not_of(' ') + 1);
    if (!text.empty() || !line.empty()) text += line + "\n";
  }
  return text + (console.color() ? "\033[0m" : "") + console.wrapped(meaning_of_letters(overlay), 2) + "\n";
}

}  // namespace

TerminalTraits traits_of_this_terminal(const Console& console) {
  TerminalTraits traits;
  // A job in the background may not change the terminal: it would be stopped.
  traits.is_watched = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0 && tcgetpgrp(STDIN_FILENO) == getpgrp();
  traits.is_plain = console.plain();
  traits.term = environment("TERM");
  traits.term_program = environment("TERM_PROGRAM");
  traits.has_kitty_window = !environment("KITTY_WINDOW_ID").empty();
  traits.is_multiplexed =
      !environment("TMUX").empty() || traits.term.starts_with("screen") || traits.term.starts_with("tmux");
  return traits;
}

GraphicsAnswer read_graphics_answer(std::string_view reply) {
  return {.kitty = reply.find("\033_Gi=31;OK\033\\") != std::string_view::npos,
          .sixel = device_attributes(reply).find(";4;") != std::string::npos};
}

GraphicsAnswer ask_terminal() {
  const std::string reply = question_and_answer();
  if (reply.find(interrupt_key) != std::string::npos) std::raise(SIGINT);
  return read_graphics_answer(reply);
}

PictureKind choose_picture(PictureKind wanted, std::size_t plots, const TerminalTraits& traits,
                           const std::function<GraphicsAnswer()>& ask) {
  if (wanted != PictureKind::automatic) return wanted;
  if (plots != 1 || !traits.is_watched || traits.is_plain) return PictureKind::none;
  if (traits.term.empty() || traits.term == "dumb") return PictureKind::text;
  // These are inherited through a multiplexer, and may be wrong there.
  const bool is_kitty = traits.term == "xterm-kitty" || traits.term == "xterm-ghostty" || traits.has_kitty_window ||
                        traits.term_program == "ghostty" || traits.term_program == "WezTerm";
  if (is_kitty && !traits.is_multiplexed) return PictureKind::kitty;
  const GraphicsAnswer answer = ask();
  return answer.kitty ? PictureKind::kitty : answer.sixel ? PictureKind::sixel : PictureKind::text;
}

std::string kitty_picture(std::string_view png, std::size_t columns) {
  constexpr std::size_t longest_chunk = 4096;  // of base64 in one escape sequence, by kitty's rules
  const std::string text = base64(png);
  std::string result;
  for (std::size_t begin = 0; begin < text.size(); begin += longest_chunk) {
    const bool more = begin + longest_chunk < text.size();
    // q=2: no answer, which would end up on the shell's next line.
    const std::string control = begin == 0 ? fmt::format("a=T,f=100,q=2,c={},", columns) : "";
    result += fmt::format("\033_G{}m={};{}\033\\", control, more ? 1 : 0, text.substr(begin, longest_chunk));
  }
  return result;
}

std::string terminal_picture(PictureKind kind, const Overlay& overlay, const fs::path& png, const Console& console) {
  const fs::path directory = png.parent_path();
  if (kind == PictureKind::kitty) return kitty_picture(read_file(png).value_or(""), space_on(console).columns) + "\n";
  if (kind == PictureKind::sixel) return sixel_picture(overlay, directory, space_on(console)) + "\n";
  return kind == PictureKind::text ? letter_picture(overlay, directory, console) : "";
}

}  // namespace workbook
