#include "checker/report/console.hpp"

#include <fmt/color.h>
#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace workbook {

namespace {

constexpr std::size_t narrowest = 30;     // below that, wrapping hurts more than it helps
constexpr std::size_t comfortable = 100;  // longer lines are hard to read

fmt::text_style text_style(Style style) {
  switch (style) {
    case Style::plain:
      return {};
    case Style::strong:
      return fmt::emphasis::bold;
    case Style::quiet:
      return fmt::emphasis::faint;
    case Style::good:
      return fmt::fg(fmt::terminal_color::green) | fmt::emphasis::bold;
    case Style::bad:
      return fmt::fg(fmt::terminal_color::red) | fmt::emphasis::bold;
    case Style::warning:
      return fmt::fg(fmt::terminal_color::yellow);
  }
  return {};
}

}  // namespace

Console Console::of_standard_output() {
  const char* term = std::getenv("TERM");
  const char* no_color = std::getenv("NO_COLOR");
  const bool terminal = isatty(STDOUT_FILENO) != 0;
  const bool color =
      terminal && (no_color == nullptr || *no_color == '\0') && term != nullptr && std::strcmp(term, "dumb") != 0;
  std::size_t width = 80;
  winsize size{};
  if (terminal && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    width = size.ws_col;
  } else if (const char* columns = std::getenv("COLUMNS")) {
    const long said = std::strtol(columns, nullptr, 10);
    if (said > 0) width = static_cast<std::size_t>(said);
  }
  return Console(std::max(width, narrowest), color);
}

std::string Console::styled(const std::string& text, Style style) const {
  if (!color_ || style == Style::plain || text.empty()) return text;
  return fmt::format(text_style(style), "{}", text);
}

std::string Console::wrapped(const std::string& text, std::size_t indent) const {
  const std::size_t limit = std::max(narrowest, std::min(width_, comfortable + indent));
  const std::string margin(indent, ' ');
  std::string result;
  std::istringstream lines(text);
  for (std::string source; std::getline(lines, source);) {
    std::string line = margin;
    bool empty = true;
    std::istringstream words(source);
    for (std::string word; words >> word;) {
      if (!empty && display_width(line) + 1 + display_width(word) > limit) {
        result += line + "\n";
        line = margin;
        empty = true;
      }
      line += empty ? word : " " + word;
      empty = false;
    }
    result += (empty ? "" : line) + "\n";
  }
  if (!result.empty()) result.pop_back();
  return result;
}

std::string Console::bar(std::size_t done, std::size_t total, std::size_t width) const {
  const std::size_t filled = total > 0 ? width * done / total : 0;
  return styled(std::string(filled, '#'), Style::good) + styled(std::string(width - filled, '.'), Style::quiet);
}

std::string padded(const std::string& text, std::size_t width) {
  const std::size_t taken = display_width(text);
  return taken >= width ? text : text + std::string(width - taken, ' ');
}

}  // namespace workbook
