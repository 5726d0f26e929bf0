#include "checker/messages/failures.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string case_heading(const std::string& case_name) { return fmt::format("Case “{}”", case_name); }

std::string inputs_heading() { return "Inputs"; }

std::string result_heading(const std::string& result, const std::string& unit) {
  return fmt::format("Result {}{}", result, unit);
}

std::string points_heading(const std::string& argument, const std::string& unit) {
  return fmt::format("{}{}, column by column", argument, unit);
}

std::string expected_heading() { return "expected"; }

std::string yours_heading() { return "yours"; }

std::string difference_heading() { return "difference"; }

std::string the_result() { return "the result"; }

std::string component(std::size_t number) { return fmt::format("component {}", number); }

std::string entry(std::size_t row, std::size_t col) { return fmt::format("entry ({},{})", row, col); }

std::string entry_of_matrix(std::size_t row, std::size_t col, std::size_t matrix) {
  return fmt::format("entry ({},{}) of matrix {}", row, col, matrix);
}

std::string column(std::size_t number) { return fmt::format("column {}", number); }

std::string matrix(std::size_t number) { return fmt::format("matrix {}", number); }

std::string no_number() { return "nothing"; }

std::string empty_list() { return "an empty list"; }

std::string no_value_to_show() { return "No value of yours can be shown."; }

std::string more_numbers(std::size_t count) {
  return count == 1 ? "(1 more number not shown)" : fmt::format("({} more numbers not shown)", count);
}

std::string more_columns(std::size_t count) {
  return count == 1 ? "(1 more column not shown)" : fmt::format("({} more columns not shown)", count);
}

std::string other_numbers_agree(std::size_t count) {
  return count == 1 ? "(the other number agrees)" : fmt::format("(the other {} numbers agree)", count);
}

std::string expected_up_to_sign() { return "Expected is this value or its negative, whichever is nearer to yours."; }

std::string yours_minus_expected() { return "yours − expected"; }

std::string attitude_minus_expected() { return "R(yours) − R(expected)"; }

std::string zero_for_a_right_answer(const std::string& formula) {
  return fmt::format("{}: zero for a right answer.", formula);
}

std::string column_is_off_by(std::size_t column) { return fmt::format("column {} is off by", column); }

}  // namespace workbook::messages
