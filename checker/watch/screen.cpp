#include "checker/watch/screen.hpp"

#include "checker/messages/watching.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace workbook {

namespace {

constexpr char escape = '\033';
constexpr const char* colors_off = "\033[0m";

/// The colour sequence that begins there, "\033[1m" for example; anything else is one letter.
std::size_t length_of_color(const std::string& text, std::size_t at) {
  if (text[at] != escape || at + 1 >= text.size() || text[at + 1] != '[') return 0;
  std::size_t end = at + 2;
  while (end < text.size() && ((text[end] >= '0' && text[end] <= '9') || text[end] == ';')) ++end;
  return end < text.size() && text[end] == 'm' ? end + 1 - at : 0;
}

std::size_t length_of_letter(const std::string& text, std::size_t at) {
  std::size_t length = 1;
  while (at + length < text.size() && (static_cast<unsigned char>(text[at + length]) & 0xC0) == 0x80) ++length;
  return length;
}

/// The exercise on the left, the bar and the count on the right, as far as there is room.
std::string heading(const Scene& scene, std::size_t columns, const Console& console) {
  constexpr std::size_t gap = 2;
  constexpr std::size_t shortest_bar = 8;
  constexpr std::size_t longest_bar = 24;
  const std::string count = messages::passed_of(scene.passed, scene.total);
  for (const std::string& name : {scene.lecture + " › " + scene.exercise, scene.exercise}) {
    const std::size_t taken = display_width(name) + gap + display_width(count);
    if (taken > columns) continue;
    std::string right = count;
    std::size_t space = columns - taken + gap;
    if (columns - taken > shortest_bar + gap) {
      const std::size_t width = std::min(columns - taken - gap, longest_bar);
      right = console.bar(scene.passed, scene.total, width) + " " + count;
      space -= width + 1;
    }
    return console.styled(name, Style::strong) + std::string(space, ' ') + right;
  }
  return console.styled(shortened(scene.exercise, columns), Style::strong);
}

std::string rule(std::size_t columns, const Console& console) {
  std::string line;
  for (std::size_t i = 0; i < columns; ++i) line += "─";
  return console.styled(line, Style::quiet);
}

}  // namespace

std::vector<std::string> folded(const std::string& text, std::size_t width) {
  constexpr std::size_t tab = 4;
  std::vector<std::string> rows;
  std::string row;
  std::string colors;
  std::size_t taken = 0;
  const auto end_row = [&] {
    rows.push_back(row + (colors.empty() ? "" : colors_off));
    row = colors;
    taken = 0;
  };
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\n') {
      end_row();
      ++at;
      continue;
    }
    if (const std::size_t length = length_of_color(text, at); length > 0) {
      const std::string sequence = text.substr(at, length);
      colors = sequence == colors_off || sequence == "\033[m" ? "" : colors + sequence;
      row += sequence;
      at += length;
      continue;
    }
    const std::size_t length = length_of_letter(text, at);
    std::string letter = text.substr(at, length);
    std::size_t columns = 1;
    if (letter == "\t") {
      columns = tab - taken % tab;
      letter = std::string(columns, ' ');
    } else if (length == 1 && (static_cast<unsigned char>(letter[0]) < 0x20 || letter[0] == 0x7f)) {
      letter = "?";
    }
    if (taken + columns > width && taken > 0) end_row();
    row += letter;
    taken += columns;
    at += length;
  }
  if (taken > 0 || row != colors) end_row();
  return rows;
}

Layout lay_out(const Scene& scene, TerminalSize size, const Console& console) {
  Layout layout;
  const std::size_t columns = std::max<std::size_t>(size.columns, 1);
  const std::size_t height = std::max<std::size_t>(size.rows, 1);

  std::vector<std::string> footer;
  for (const std::string& row : folded(console.wrapped(scene.keys), columns))
    footer.push_back(console.styled(row, Style::quiet));
  std::vector<std::string> header = {heading(scene, columns, console), rule(columns, console)};
  // A terminal of a few rows is for the verdict, not for its frame.
  constexpr std::size_t least_body = 3;
  if (header.size() + footer.size() + 1 + least_body > height) header.resize(1);
  if (header.size() + footer.size() + 1 + least_body > height) footer.clear();

  const std::vector<std::string> body = folded(scene.body, columns);
  layout.body_total = body.size();
  const std::size_t frame = header.size() + footer.size() + 1;  // with the line of the state
  const std::size_t room = height > frame ? height - frame : 0;
  layout.body_shown = std::min(room, body.size());
  layout.first_row = std::min(scene.first_row, body.size() - layout.body_shown);

  std::string state = scene.state;
  if (state.empty() && layout.body_shown < body.size()) {
    state = console.styled(
        messages::part_shown(layout.first_row + 1, layout.first_row + layout.body_shown, layout.body_total),
        Style::warning);
  }
  if (state.empty()) state = console.styled(scene.idle, Style::quiet);
  layout.rows = header;
  for (std::size_t i = 0; i < layout.body_shown; ++i) layout.rows.push_back(body[layout.first_row + i]);
  layout.end_of_body = layout.rows.size();
  layout.rows.resize(std::max(layout.rows.size(), height > footer.size() + 1 ? height - footer.size() - 1 : 0));
  const std::vector<std::string> state_rows = folded(state, columns);
  layout.rows.push_back(state_rows.empty() ? "" : state_rows.front());
  layout.rows.insert(layout.rows.end(), footer.begin(), footer.end());
  layout.rows.resize(std::min(layout.rows.size(), height));
  return layout;
}

}  // namespace workbook
