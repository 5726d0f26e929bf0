#include "checker/base/console.hpp"

#include "checker/base/text.hpp"

#include <fmt/color.h>
#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

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

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0' && std::strcmp(value, "0") != 0;
}

Console console_of(int descriptor) {
  const char* term = std::getenv("TERM");
  const char* no_color = std::getenv("NO_COLOR");
  const bool terminal = isatty(descriptor) != 0;
  const bool wants_color = (terminal && term != nullptr && std::strcmp(term, "dumb") != 0) || is_set("CLICOLOR_FORCE");
  const bool color = wants_color && (no_color == nullptr || *no_color == '\0');
  std::size_t width = 80;
  winsize size{};
  if (terminal && ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    width = size.ws_col;
  } else if (const char* columns = std::getenv("COLUMNS")) {
    const long said = std::strtol(columns, nullptr, 10);
    if (said > 0) width = static_cast<std::size_t>(said);
  }
  return Console(std::max(width, narrowest), color, is_set("WORKBOOK_PLAIN"));
}

}  // namespace

Console Console::of_standard_output() { return console_of(STDOUT_FILENO); }

Console Console::of_standard_error() { return console_of(STDERR_FILENO); }

std::string Console::mark(const std::string& mark, Style style) const {
  return plain_ ? "" : styled(mark, style) + " ";
}

std::string Console::styled(const std::string& text, Style style) const {
  if (!color_ || style == Style::plain || text.empty()) return text;
  return fmt::format(text_style(style), "{}", text);
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

}  // namespace workbook
