#include "checker/report/text_table.hpp"

#include "checker/base/text.hpp"
#include "checker/judging/value_text.hpp"

#include <algorithm>
#include <iterator>

namespace workbook {

namespace {

std::string blanks(std::size_t count) { return std::string(count, ' '); }

std::string without_trailing_blanks(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// One column of numbers with its heading on top, all of one width.
Lines column_texts(const Table& table, std::size_t col) {
  Lines numbers;
  for (const auto& row : table.rows) numbers.push_back(row.at(col));
  Lines cells = aligned_on_point(numbers);
  for (std::size_t row = 0; row < cells.size(); ++row) {
    if (table.is_marked) cells[row] = (table.is_marked(row, col) ? "≠ " : "  ") + cells[row];
  }
  if (!table.headings.empty()) cells.insert(cells.begin(), blanks(table.is_marked ? 2 : 0) + table.headings.at(col));
  const std::size_t width = widest(cells);
  for (std::string& cell : cells) cell = padded(cell, width);
  return cells;
}

}  // namespace

std::size_t widest(const Lines& lines) {
  std::size_t width = 0;
  for (const std::string& text : lines) width = std::max(width, display_width(text));
  return width;
}

void append(Lines& lines, Lines more) { std::ranges::move(more, std::back_inserter(lines)); }

Lines indented(Lines lines, std::size_t depth) {
  for (std::string& line : lines) line.insert(0, depth, ' ');
  return lines;
}

Lines Table::lines() const {
  if (rows.empty()) return {};
  const std::size_t heading = headings.empty() ? 0 : 1;
  const std::size_t label_width = widest(labels);
  const std::string gap = blanks(is_marked ? 1 : 2);  // there is room beside the marks

  Lines text(rows.size() + heading);
  for (std::size_t row = 0; row < text.size(); ++row) {
    const bool has_label = row >= heading && !labels.empty();
    text[row] = padded_left(has_label ? labels.at(row - heading) : "", label_width);
  }
  for (std::size_t col = 0; col < rows.front().size(); ++col) {
    const Lines cells = column_texts(*this, col);
    const bool is_leftmost = col == 0 && labels.empty();
    for (std::size_t row = 0; row < text.size(); ++row) text[row] += (is_leftmost ? "" : gap) + cells[row];
  }
  for (std::size_t row = 0; row < endings.size(); ++row) text[row + heading] += " " + endings[row];
  for (std::string& line : text) line = without_trailing_blanks(line);
  return text;
}

Lines side_by_side(const std::vector<Block>& blocks, std::size_t indent, const Page& page) {
  constexpr std::size_t gap = 3;
  Lines result;
  Lines band;  // blocks that stand beside each other
  std::size_t band_width = 0;
  const auto finish_band = [&] {
    for (const std::string& line : band) result.push_back(without_trailing_blanks(blanks(indent) + line));
    band.clear();
    band_width = 0;
  };

  for (const Block& block : blocks) {
    Lines lines = {block.title};
    lines.insert(lines.end(), block.lines.begin(), block.lines.end());
    const std::size_t width = widest(lines);
    const bool fits = !page.is_linear && indent + band_width + gap + width <= page.width;
    if (!band.empty() && !fits) finish_band();
    const std::size_t start = band.empty() ? 0 : band_width + gap;
    band.resize(std::max(band.size(), lines.size()));
    for (std::size_t row = 0; row < lines.size(); ++row) band[row] = padded(band[row], start) + lines[row];
    band_width = start + width;
  }
  finish_band();
  return result;
}

Lines wrapped_in_columns(const Lines& texts, std::size_t indent, const Page& page) {
  const std::size_t width = widest(texts) + 2;
  const std::size_t per_line = std::max<std::size_t>(1, (page.width - indent + 2) / width);
  Lines lines;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    if (k % per_line == 0) lines.push_back(blanks(indent));
    lines.back() += padded(texts[k], width);
  }
  for (std::string& line : lines) line = without_trailing_blanks(line);
  return lines;
}

Table matrix_table(const Value& value, std::size_t first_col, int digits, const NumberTest& is_marked) {
  const auto number_at = [first_col](std::size_t row, std::size_t col) { return 3 * (first_col + col) + row; };
  Table table;
  for (std::size_t row = 0; row < 3; ++row) {
    table.rows.emplace_back();
    for (std::size_t col = 0; col < 3; ++col) {
      table.rows.back().push_back(number_text(value.numbers.at(number_at(row, col)), digits));
    }
  }
  if (is_marked) {
    table.is_marked = [=](std::size_t row, std::size_t col) { return is_marked(number_at(row, col)); };
  }
  return table;
}

}  // namespace workbook
