#include "checker/judging/text_blocks.hpp"

#include "checker/judging/value_text.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace workbook {

namespace {

std::string blanks(std::size_t count) { return std::string(count, ' '); }

std::string padded_right(const std::string& text, std::size_t width) {
  return text + blanks(width - std::min(width, display_width(text)));
}

std::string padded_left(const std::string& text, std::size_t width) {
  return blanks(width - std::min(width, display_width(text))) + text;
}

std::string without_trailing_blanks(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// One column of numbers with its heading on top, all of one width.
std::vector<std::string> column_texts(const Table& table, std::size_t col) {
  std::vector<std::string> numbers;
  for (const auto& row : table.rows) numbers.push_back(row.at(col));
  std::vector<std::string> cells = aligned_on_point(numbers);
  for (std::size_t row = 0; row < cells.size(); ++row) {
    if (table.is_marked)
      cells[row] = (table.is_marked(row, col) ? std::string(differing_mark) + " " : blanks(2)) + cells[row];
  }
  if (!table.headings.empty()) cells.insert(cells.begin(), blanks(table.is_marked ? 2 : 0) + table.headings.at(col));
  const std::size_t width = widest(cells);
  for (std::string& cell : cells) cell = padded_right(cell, width);
  return cells;
}

}  // namespace

std::size_t widest(const std::vector<std::string>& lines) {
  std::size_t width = 0;
  for (const std::string& text : lines) width = std::max(width, display_width(text));
  return width;
}

void append(std::vector<std::string>& lines, std::vector<std::string> more) {
  std::ranges::move(more, std::back_inserter(lines));
}

std::vector<std::string> indented(std::vector<std::string> lines, std::size_t depth) {
  for (std::string& line : lines) line.insert(0, depth, ' ');
  return lines;
}

std::string in_brackets(const std::string& unit) { return unit.empty() ? "" : " [" + unit + "]"; }

std::vector<std::string> table_lines(const Table& table) {
  if (table.rows.empty()) return {};
  const std::size_t heading = table.headings.empty() ? 0 : 1;
  const std::size_t label_width = widest(table.labels);
  const std::string gap = blanks(table.is_marked ? 1 : 2);  // there is room beside the marks

  std::vector<std::string> lines(table.rows.size() + heading);
  for (std::size_t row = 0; row < lines.size(); ++row) {
    const bool has_label = row >= heading && !table.labels.empty();
    lines[row] = padded_left(has_label ? table.labels.at(row - heading) : "", label_width);
  }
  for (std::size_t col = 0; col < table.rows.front().size(); ++col) {
    const std::vector<std::string> cells = column_texts(table, col);
    const bool is_leftmost = col == 0 && table.labels.empty();
    for (std::size_t row = 0; row < lines.size(); ++row) lines[row] += (is_leftmost ? "" : gap) + cells[row];
  }
  for (std::size_t row = 0; row < table.endings.size(); ++row) lines[row + heading] += " " + table.endings[row];
  for (std::string& line : lines) line = without_trailing_blanks(line);
  return lines;
}

std::vector<std::string> side_by_side(const std::vector<Block>& blocks, std::size_t indent, const Page& page) {
  constexpr std::size_t gap = 3;
  std::vector<std::string> result;
  std::vector<std::string> band;  // blocks that stand beside each other
  std::size_t band_width = 0;
  const auto finish_band = [&] {
    for (const std::string& line : band) result.push_back(without_trailing_blanks(blanks(indent) + line));
    band.clear();
    band_width = 0;
  };

  for (const Block& block : blocks) {
    std::vector<std::string> lines = {block.title};
    lines.insert(lines.end(), block.lines.begin(), block.lines.end());
    const std::size_t width = widest(lines);
    const bool fits = !page.is_linear && indent + band_width + gap + width <= page.width;
    if (!band.empty() && !fits) finish_band();
    const std::size_t start = band.empty() ? 0 : band_width + gap;
    band.resize(std::max(band.size(), lines.size()));
    for (std::size_t row = 0; row < lines.size(); ++row) band[row] = padded_right(band[row], start) + lines[row];
    band_width = start + width;
  }
  finish_band();
  return result;
}

std::vector<std::string> wrapped_in_columns(const std::vector<std::string>& texts, std::size_t indent,
                                            const Page& page) {
  const std::size_t width = widest(texts) + 2;
  const std::size_t per_line = std::max<std::size_t>(1, (page.width - indent + 2) / width);
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    if (k % per_line == 0) lines.push_back(blanks(indent));
    lines.back() += padded_right(texts[k], width);
  }
  for (std::string& line : lines) line = without_trailing_blanks(line);
  return lines;
}

std::vector<std::string> wrapped(const std::string& sentence, std::size_t indent, const Page& page) {
  std::vector<std::string> lines = {blanks(indent)};
  std::istringstream words(sentence);
  for (std::string word; words >> word;) {
    const bool is_first = display_width(lines.back()) == indent;
    if (!is_first && display_width(lines.back()) + 1 + display_width(word) > page.width) {
      lines.push_back(blanks(indent) + word);
    } else {
      lines.back() += (is_first ? "" : " ") + word;
    }
  }
  return lines;
}

}  // namespace workbook
