#include "checker/judging/value_tables.hpp"

#include "checker/judging/value_text.hpp"

namespace workbook {

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

Table columns_table(const Value& value, std::size_t count) {
  Table table;
  for (std::size_t col = 0; col < count; ++col) {
    table.labels.push_back(std::to_string(col + 1));
    table.rows.emplace_back();
    for (int row = 0; row < value.rows; ++row) {
      table.rows.back().push_back(number_text(value.at(row, static_cast<int>(col)), all_digits));
    }
  }
  return table;
}

}  // namespace workbook
