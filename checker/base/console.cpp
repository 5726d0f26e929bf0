#include "checker/base/console.hpp"

#include "checker/base/text.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace workbook {

namespace {

constexpr std::size_t narrowest = 30;     // below that, wrapping hurts more than it helps
constexpr std::size_t comfortable = 100;  // longer lines are hard to read

constexpr const char* codes[] = {"", "\033[1m", "\033[2m", "\033[1m\033[32m", "\033[1m\033[31m", "\033[33m"};

bool is_set(const char* name) { return environment(name, "0") != "0"; }

Console console_of(int descriptor) {
  const bool terminal = isatty(descriptor) != 0;
  const bool is_smart = terminal && environment("TERM", "dumb") != "dumb";
  // These drop links, and would leave words without an address.
  const bool drops_links =
      !environment("TMUX").empty() || !environment("STY").empty() || environment("TERM") == "linux";
  winsize size{};
  long width = std::strtol(environment("COLUMNS").c_str(), nullptr, 10);
  if (terminal && ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) width = size.ws_col;
  return Console(width > 0 ? std::max(static_cast<std::size_t>(width), narrowest) : 80,
                 (is_smart || is_set("CLICOLOR_FORCE")) && environment("NO_COLOR").empty(), is_set("WORKBOOK_PLAIN"),
                 is_smart && !drops_links);
}

}  // namespace

Console Console::of_standard_output() { return console_of(STDOUT_FILENO); }

Console Console::of_standard_error() { return console_of(STDERR_FILENO); }

std::string Console::mark(const std::string& mark, Style style) const {
  return plain_ ? "" : styled(mark, style) + " ";
}

std::string Console::styled(const std::string& text, Style style) const {
  if (!color_ || style == Style::plain || text.empty()) return text;
  return codes[static_cast<int>(style)] + text + "\033[0m";
}

std::string Console::linked(const std::string& text, const std::string& address) const {
  if (!has_links_) return address;
  return "\033]8;;" + address + "\033\\" + text + "\033]8;;\033\\";
}

std::string Console::wrapped(const std::string& text, std::size_t indent) const {
  const std::size_t limit = std::max(narrowest, std::min(width_, comfortable + indent));
  return fmt::format("{}", fmt::join(wrapped_lines(text, limit, indent), "\n"));
}

std::string Console::bar(std::size_t done, std::size_t total, std::size_t width) const {
  if (plain_) return "";
  const std::size_t filled = total > 0 ? width * done / total : 0;
  return styled(std::string(filled, '#'), Style::good) + styled(std::string(width - filled, '.'), Style::quiet);
}

ProgressBar::ProgressBar(bool wanted)
    : wanted_(wanted && isatty(STDERR_FILENO) != 0 && !Console::of_standard_error().plain()) {}

void ProgressBar::show(std::size_t done, std::size_t total, const std::string& what) {
  if (!wanted_) return;
  const Console console = Console::of_standard_error();
  const std::string count = fmt::format(" {} of {}  ", done, total);
  const std::size_t bar_width = std::clamp<std::size_t>(console.width() / 4, 5, 24);
  // A line that is wider than the terminal would break and could not be written over.
  const std::size_t left = console.width() - std::min(console.width(), bar_width + display_width(count) + 1);
  fmt::print(stderr, "\r\033[K{}{}{}", console.bar(done, total, bar_width), count, shortened(what, left));
  std::fflush(stderr);
  shown_ = true;
}

void ProgressBar::clear() {
  if (!std::exchange(shown_, false)) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

}  // namespace workbook
