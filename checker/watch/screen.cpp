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

/// What takes one column, and the colours that are on there.
struct Letter {
  std::string text;
  std::string colors;
};

/// A line as letters. @param colors  those that are on before the line, and afterwards those that are on behind it
std::vector<Letter> letters_of(const std::string& line, std::string& colors) {
  constexpr std::size_t tab = 4;
  std::vector<Letter> letters;
  for (std::size_t at = 0; at < line.size();) {
    if (const std::size_t length = length_of_color(line, at); length > 0) {
      const std::string sequence = line.substr(at, length);
      if (sequence == colors_off || sequence == "\033[m")
        colors.clear();
      else
        colors += sequence;
      at += length;
      continue;
    }
    const std::size_t length = length_of_letter(line, at);
    const auto first = static_cast<unsigned char>(line[at]);
    if (first == '\t') {
      do letters.push_back({" ", colors});
      while (letters.size() % tab != 0);
    } else {
      letters.push_back({first < 0x20 || first == 0x7f ? "?" : line.substr(at, length), colors});
    }
    at += length;
  }
  return letters;
}

/// Where a row that begins there ends: between words, unless that would leave it nearly empty.
std::size_t end_of_row(const std::vector<Letter>& line, std::size_t begin, std::size_t width) {
  const std::size_t most = begin + std::max<std::size_t>(width, 1);
  if (line.size() <= most) return line.size();
  for (std::size_t stop = most; stop > begin + width / 2; --stop) {
    if (line[stop].text == " ") return stop;
  }
  return most;
}

std::string row_of(const std::vector<Letter>& line, std::size_t begin, std::size_t end) {
  std::string row;
  std::string colors;
  for (std::size_t i = begin; i < end; ++i) {
    if (line[i].colors != colors) {
      if (!colors.empty()) row += colors_off;
      colors = line[i].colors;
      row += colors;
    }
    row += line[i].text;
  }
  return row + (colors.empty() ? "" : colors_off);
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

/// As many beside each other as there is room for; a key stays beside its word.
std::vector<std::string> rows_of_keys(const std::vector<std::string>& keys, std::size_t columns) {
  const std::string between = " · ";
  std::vector<std::string> rows;
  for (const std::string& key : keys) {
    const std::string added = between + key;
    if (!rows.empty() && display_width(rows.back()) + display_width(added) <= columns)
      rows.back() += added;
    else
      rows.push_back(shortened(key, columns));
  }
  return rows;
}

std::string rule(std::size_t columns, const Console& console) {
  std::string line;
  for (std::size_t i = 0; i < columns; ++i) line += "─";
  return console.styled(line, Style::quiet);
}

}  // namespace

std::vector<std::string> folded(const std::string& text, std::size_t width) {
  std::vector<std::string> rows;
  std::string colors;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::vector<Letter> line = letters_of(text.substr(at, end - at), colors);
    std::size_t begin = 0;
    do {
      const std::size_t stop = end_of_row(line, begin, width);
      rows.push_back(row_of(line, begin, stop));
      begin = stop;
      // A break takes the place of the spaces there.
      while (begin < line.size() && line[begin].text == " ") ++begin;
    } while (begin < line.size());
    at = end + 1;
  }
  return rows;
}

Layout lay_out(const Scene& scene, TerminalSize size, const Console& console) {
  Layout layout;
  const std::size_t columns = std::max<std::size_t>(size.columns, 1);
  const std::size_t height = std::max<std::size_t>(size.rows, 1);

  std::vector<std::string> footer;
  for (const std::string& row : rows_of_keys(scene.keys, columns)) footer.push_back(console.styled(row, Style::quiet));
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
