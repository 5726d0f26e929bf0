#include "checker/judging/input_text.hpp"

#include "checker/judging/text_blocks.hpp"
#include "checker/judging/value_tables.hpp"
#include "checker/judging/value_text.hpp"
#include "checker/messages/failures.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace workbook {

namespace {

constexpr std::size_t indent = 2;

std::string after_blank(const std::string& unit) { return unit.empty() ? "" : " " + unit; }

std::vector<std::string> vector_lines(const std::string& name, const std::string& unit, const Value& value,
                                      const Page& page) {
  const std::string line = fmt::format("{} = {}{}", name, format_value(value, Kind::vector), after_blank(unit));
  if (indent + display_width(line) <= page.width) return {line};
  std::vector<std::string> texts;
  for (double number : value.numbers) texts.push_back(number_text(number, all_digits));
  std::vector<std::string> lines = {name + in_brackets(unit)};
  append(lines, wrapped_in_columns(aligned_on_point(texts), indent, page));
  return lines;
}

}  // namespace

std::vector<std::string> input_lines(const Argument& argument, const Value& value, const Page& page) {
  const std::string unit = to_string(argument.unit);
  if (is_vector(argument.kind)) return vector_lines(argument.name, unit, value, page);
  if (argument.kind == Kind::number || argument.kind == Kind::integer || value.cols == 0) {
    return {fmt::format("{} = {}{}", argument.name, format_value(value, argument.kind), after_blank(unit))};
  }

  std::vector<std::string> lines = {argument.name + in_brackets(unit)};
  const auto cols = static_cast<std::size_t>(value.cols);
  switch (argument.kind) {
    case Kind::points: {
      lines.front() = messages::points_heading(argument.name, in_brackets(unit));
      const std::size_t shown = std::min(cols, most_rows);
      append(lines, indented(table_lines(columns_table(value, shown)), indent));
      if (shown < cols) lines.push_back("  " + messages::more_columns(cols - shown));
      break;
    }
    case Kind::matrices: {
      std::vector<Block> blocks;
      for (std::size_t m = 0; m < cols / 3; ++m) {
        blocks.push_back({messages::matrix(m + 1), table_lines(matrix_table(value, 3 * m, all_digits))});
      }
      append(lines, side_by_side(blocks, indent, page));
      break;
    }
    default:
      append(lines, indented(table_lines(matrix_table(value, 0, all_digits)), indent));
  }
  return lines;
}

}  // namespace workbook
