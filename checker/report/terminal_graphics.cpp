#include "checker/report/terminal_graphics.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <regex>

namespace workbook {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds patience{200};
constexpr char interrupt_key = '\003';

/// One pixel, only tried; then the device attributes, which every terminal answers: so we need not wait for a "no".
constexpr std::string_view question = "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\\033[c";

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Lets single letters through, unechoed, as long as it lives.
class UnbufferedInput {
 public:
  UnbufferedInput() : changed_(tcgetattr(STDIN_FILENO, &before_) == 0) {
    if (!changed_) return;
    termios raw = before_;
    // Without the interrupt key as well: a process ended here would leave the terminal mute.
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
    raw.c_cc[VMIN] = 0;
    raw.c_cc[VTIME] = 0;
    changed_ = tcsetattr(STDIN_FILENO, TCSADRAIN, &raw) == 0;
  }
  ~UnbufferedInput() {
    if (changed_) tcsetattr(STDIN_FILENO, TCSADRAIN, &before_);
  }
  UnbufferedInput(const UnbufferedInput&) = delete;
  UnbufferedInput& operator=(const UnbufferedInput&) = delete;

  explicit operator bool() const { return changed_; }

 private:
  termios before_{};
  bool changed_;
};

bool has_input(std::chrono::milliseconds wait) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, static_cast<int>(wait.count())) == 1 && (input.revents & POLLIN) != 0;
}

const std::regex& device_attributes() {
  static const std::regex pattern("\033\\[\\?[0-9]+((;[0-9]+)*)c");
  return pattern;
}

/// Everything up to the end of the second answer, or what came in time.
std::string question_and_answer() {
  std::string reply;
  const UnbufferedInput input;
  if (!input || has_input(std::chrono::milliseconds(0))) return reply;
  if (write(STDOUT_FILENO, question.data(), question.size()) != static_cast<ssize_t>(question.size())) return reply;
  const Clock::time_point deadline = Clock::now() + patience;
  while (!std::regex_search(reply, device_attributes()) && reply.find(interrupt_key) == std::string::npos) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0 || !has_input(left)) break;
    char letters[256];
    const ssize_t count = read(STDIN_FILENO, letters, sizeof letters);
    if (count <= 0) break;
    reply.append(letters, static_cast<std::size_t>(count));
  }
  return reply;
}

}  // namespace

TerminalTraits traits_of_this_terminal(const Console& console) {
  TerminalTraits traits;
  // A job in the background may not change the terminal: it would be stopped.
  traits.is_watched = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0 && tcgetpgrp(STDIN_FILENO) == getpgrp();
  traits.is_plain = console.plain();
  traits.term = variable("TERM");
  traits.term_program = variable("TERM_PROGRAM");
  traits.has_kitty_window = !variable("KITTY_WINDOW_ID").empty();
  traits.is_multiplexed =
      !variable("TMUX").empty() || traits.term.starts_with("screen") || traits.term.starts_with("tmux");
  return traits;
}

GraphicsAnswer read_graphics_answer(std::string_view reply) {
  GraphicsAnswer answer;
  answer.kitty = reply.find("\033_Gi=31;OK\033\\") != std::string_view::npos;
  std::match_results<std::string_view::const_iterator> match;
  if (std::regex_search(reply.begin(), reply.end(), match, device_attributes())) {
    answer.sixel = (match[1].str() + ";").find(";4;") != std::string::npos;
  }
  return answer;
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

PictureSpace picture_space(const Console& console) {
  PictureSpace space;
  space.columns = console.width();
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0 && size.ws_col > 0) {
    space.rows = size.ws_row;
    if (size.ws_xpixel >= size.ws_col && size.ws_ypixel >= size.ws_row) {
      space.cell_width = size.ws_xpixel / size.ws_col;
      space.cell_height = size.ws_ypixel / size.ws_row;
    }
  }
  return space;
}

}  // namespace workbook
