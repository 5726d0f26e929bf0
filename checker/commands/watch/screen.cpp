#include "checker/commands/watch/watch.hpp"

#include <algorithm>

namespace workbook {

namespace {

/// The exercise on the left, the bar and the count on the right, as far as there is space.
std::string heading(const Scene& scene, std::size_t columns, const Console& console) {
  const std::string count = fmt::format("{} of {}", scene.passed, scene.total);
  for (const std::string& name : {scene.lecture + " › " + scene.exercise, scene.exercise}) {
    const std::size_t taken = display_width(name) + 2 + display_width(count);
    if (taken > columns) continue;
    const std::size_t bar = columns - taken < 12 ? 0 : std::min<std::size_t>(columns - taken - 1, 24);
    return console.styled(name, Style::strong) + std::string(columns - taken + 2 - bar - (bar > 0 ? 1 : 0), ' ') +
           (bar > 0 ? console.bar(scene.passed, scene.total, bar) + " " : "") + count;
  }
  return console.styled(shortened(scene.exercise, columns), Style::strong);
}

constexpr std::string_view end_of_link = "\033]8;;\033\\";

/// Where the character, the colour sequence, or the beginning or end of a link, that begins there ends.
std::size_t end_of_character(const std::string& line, std::size_t at) {
  if (line.compare(at, 5, end_of_link.substr(0, 5)) == 0) {
    const std::size_t end = line.find("\033\\", at + 5);
    if (end != std::string::npos) return end + 2;
  }
  if (line.compare(at, 2, "\033[") == 0) {
    const std::size_t end = line.find_first_not_of("0123456789;", at + 2);
    if (end != std::string::npos && line[end] == 'm') return end + 1;
  }
  for (++at; at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0) == 0x80;) ++at;
  return at;
}

}  // namespace

std::vector<std::string> folded(const std::string& text, std::size_t width) {
  std::vector<std::string> rows;
  std::string colors, link;  // that are on
  for (const std::string& line : lines_of(text)) {
    std::string row = colors + link;
    std::size_t columns = 0;
    const auto end_row = [&] {
      if (!link.empty()) row += end_of_link;
      rows.push_back(std::exchange(row, colors + link) + (colors.empty() ? "" : "\033[0m"));
    };
    for (std::size_t at = 0, end = 0; at < line.size(); at = end) {
      end = end_of_character(line, at);
      std::string character = line.substr(at, end - at);
      if (character[0] == '\033' && character.ends_with('m')) {
        if (character == "\033[0m") colors.clear();
        if (character != "\033[0m") colors += character;
        row += character;
        continue;
      }
      if (character[0] == '\033' && character.size() > 5) {
        link = character == end_of_link ? "" : character;
        row += character;
        continue;
      }
      if (columns++ == width) {
        end_row();
        columns = 1;
      }
      const auto first = static_cast<unsigned char>(character[0]);
      row += first == '\t' ? " " : first < 0x20 || first == 0x7f ? "?" : character;
    }
    end_row();
  }
  return rows;
}

Layout lay_out(const Scene& scene, TerminalSize size, const Console& console) {
  std::vector<std::string> header = {heading(scene, size.columns, console),
                                     console.styled(fmt::format("{:─>{}}", "", size.columns), Style::quiet)};
  std::vector<std::string> footer = wrapped_lines(scene.keys, size.columns);
  for (std::string& row : footer) row = console.styled(shortened(row, size.columns), Style::quiet);
  // A terminal of a few rows is for the verdict, not for its frame.
  if (header.size() + footer.size() + 4 > size.rows) header.resize(1);
  if (header.size() + footer.size() + 4 > size.rows) footer.clear();

  const std::vector<std::string> body = folded(scene.body, size.columns);
  const std::size_t frame = header.size() + 1 + footer.size();  // with the line of the state
  Layout layout;
  layout.body_shown = std::min(size.rows - std::min(size.rows, frame), body.size());
  layout.first_row = std::min(scene.first_row, body.size() - layout.body_shown);
  const std::size_t last = layout.first_row + layout.body_shown;
  std::string state = scene.state;
  if (state.empty() && layout.body_shown < body.size())
    state = console.styled(fmt::format("Lines {}–{} of {}: {}", layout.first_row + 1, last, body.size(),
                                       last < body.size() ? "space or ↓ shows more" : "↑ goes back up"),
                           Style::warning);
  if (state.empty()) state = console.styled(scene.idle, Style::quiet);

  layout.rows = header;
  const auto begin = body.begin() + static_cast<std::ptrdiff_t>(layout.first_row);
  layout.rows.insert(layout.rows.end(), begin, begin + static_cast<std::ptrdiff_t>(layout.body_shown));
  layout.end_of_body = layout.rows.size();
  layout.rows.resize(std::max(layout.end_of_body, size.rows - std::min(size.rows, footer.size() + 1)));
  layout.rows.push_back(state.empty() ? "" : folded(state, size.columns).front());
  layout.rows.insert(layout.rows.end(), footer.begin(), footer.end());
  layout.rows.resize(size.rows);
  return layout;
}

}  // namespace workbook
