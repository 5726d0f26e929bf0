#include "checker/report/reports.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace workbook {

namespace {

constexpr std::size_t widest_picture = 100;  // in columns; larger ones show no more
constexpr std::size_t rows_for_text = 4;     // the paths and the next prompt stay in sight

/// So many that the whole of a picture is seen at once.
std::size_t rows_for_picture() {
  winsize size{};
  const bool is_known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0;
  return std::max<std::size_t>(10 + rows_for_text, is_known ? size.ws_row : 24) - rows_for_text;
}

/// What chafa prints, if it is installed and takes this terminal for one that shows graphics; else "".
std::string graphics_picture(const fs::path& png, const Console& console) {
  const std::string chafa = program_on_path("chafa");
  if (chafa.empty()) return "";
  Launch launch;
  launch.program = chafa;
  launch.arguments = {"--size", fmt::format("{}x{}", std::min(console.width(), widest_picture), rows_for_picture()),
                      png.string()};
  for (char** variable = environ; *variable != nullptr; ++variable) launch.environment.emplace_back(*variable);
  const FinishedProgram ran = run_program(launch, std::chrono::seconds(10), std::size_t{64} << 20);
  // How kitty's protocol, sixel and iTerm's begin. What it makes of characters is less clear than our own letters.
  const bool is_graphics = ran.succeeded() && search(ran.output.substr(0, 100), "\033(_G|P|\\]1337)");
  return is_graphics ? ran.output + "\n" : "";
}

}  // namespace

bool shows_pictures(std::size_t plots, const Console& console) {
  return plots == 1 && isatty(STDOUT_FILENO) != 0 && !console.plain();
}

std::string terminal_picture(const Overlay& overlay, const fs::path& png, const Console& console) {
  const std::string graphics = graphics_picture(png, console);
  return graphics.empty() ? letter_picture(overlay, png.parent_path(), console) : graphics;
}

std::string letter_picture(const Overlay& overlay, const fs::path& directory, const Console& console) {
  const std::size_t columns = std::min(console.width(), widest_picture) - 1;
  const std::size_t rows = std::clamp<std::size_t>(rows_for_picture(), 12, 28);
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

}  // namespace workbook
