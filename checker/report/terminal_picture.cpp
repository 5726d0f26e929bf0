#include "checker/report/terminal_picture.hpp"

#include "checker/base/base64.hpp"
#include "checker/messages/plotting.hpp"
#include "checker/report/overlay_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace workbook {

namespace {

constexpr std::size_t longest_chunk = 4096;  // of base64 in one escape sequence, by kitty's rules
constexpr double shape = 1.25;               // width over height of the drawn pictures
constexpr std::size_t widest = 100;          // in columns; larger pictures say no more
constexpr std::size_t rows_for_text = 4;     // the paths and the next prompt stay in sight

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t rows_for_picture(const PictureSpace& space) {
  return std::max<std::size_t>(10, space.rows - std::min(space.rows, rows_for_text));
}

/// The most columns at which the picture is not taller than the window.
std::size_t picture_columns(const PictureSpace& space) {
  const double cells = shape * static_cast<double>(space.cell_height) / static_cast<double>(space.cell_width);
  const auto columns = static_cast<std::size_t>(static_cast<double>(rows_for_picture(space)) * cells);
  return std::min({columns, space.columns, widest});
}

std::string sixel_picture(const Overlay& overlay, const std::filesystem::path& directory, const PictureSpace& space) {
  const std::size_t width = picture_columns(space) * space.cell_width;
  const auto height = static_cast<std::size_t>(static_cast<double>(width) / shape);
  // Letters and lines shrink with the picture, as far as they can be read.
  const double scale = std::clamp(static_cast<double>(width) / 800.0, 0.6, 1.5);
  const std::string terminal = fmt::format(
      "sixelgd noenhanced truecolor size {},{} font 'Helvetica,{:.0f}' linewidth {:.1f} background rgb 'white'", width,
      height, 11 * scale, scale);
  return drawn_picture(terminal, directory, [&](gnuplotio::Gnuplot& gnuplot) { send_panels(gnuplot, overlay); });
}

std::string without_trailing_blanks(const std::string& text) {
  std::string result;
  std::string blanks;
  for (const char letter : text) {
    if (letter == ' ') {
      blanks += letter;
      continue;
    }
    if (letter != '\n') result += blanks;
    blanks.clear();
    if (letter != '\f') result += letter;  // gnuplot begins with a new page
  }
  return result;
}

std::string meaning_of_letters(const Overlay& overlay, const Console& console) {
  std::string text;
  for (std::size_t k = 0; k < overlay.sweep->components.size(); ++k) {
    const std::string label = component_label(overlay, overlay.sweep->components[k]);
    text += (k == 0 ? "" : ";  ") + messages::letters_of_component(label, student_letters[k % 9],
                                                                   reference_letters[k % 3], !overlay.student.empty());
  }
  if (overlay.misconception_outputs != nullptr)
    text += ";  " + messages::letters_of_misconception(misconception_letter, overlay.misconception);
  return console.wrapped(text, 2) + "\n";
}

std::string letter_picture(const Overlay& overlay, const std::filesystem::path& directory, const Console& console,
                           const PictureSpace& space) {
  const std::size_t columns = std::min(console.width(), widest);
  const std::size_t rows = std::clamp<std::size_t>(rows_for_picture(space), 12, 28);
  const std::string drawing = drawn_picture(
      fmt::format("dumb noenhanced size {},{} {}", columns - 1, rows, console.color() ? "ansi256" : "mono"), directory,
      [&](gnuplotio::Gnuplot& gnuplot) { send_letters(gnuplot, overlay, columns); });
  const std::string lines = without_trailing_blanks(drawing);
  return lines.substr(std::min(lines.size(), lines.find_first_not_of('\n'))) + (console.color() ? "\033[0m" : "") +
         meaning_of_letters(overlay, console);
}

}  // namespace

std::string kitty_picture(std::string_view png, std::size_t columns) {
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

std::string terminal_picture(PictureKind kind, const Overlay& overlay, const std::vector<std::filesystem::path>& drawn,
                             const std::filesystem::path& directory, const Console& console,
                             const PictureSpace& space) {
  switch (kind) {
    case PictureKind::kitty:
      return kitty_picture(bytes_of(drawn.back()), picture_columns(space)) + "\n";
    case PictureKind::sixel:
      return sixel_picture(overlay, directory, space) + "\n";
    case PictureKind::text:
      return letter_picture(overlay, directory, console, space);
    case PictureKind::automatic:
    case PictureKind::none:
      break;
  }
  return "";
}

}  // namespace workbook
