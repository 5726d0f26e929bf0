#include "checker/messages/broken_properties.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string entry_is(std::size_t row, std::size_t col, const std::string& number) {
  return fmt::format("entry ({},{}) is {}", row, col, number);
}

std::string two_entries_are(std::size_t row, std::size_t col, const std::string& number, std::size_t other_row,
                            std::size_t other_col, const std::string& other_number) {
  return fmt::format("entry ({},{}) is {}, entry ({},{}) is {}", row, col, number, other_row, other_col, other_number);
}

std::string two_components_are(std::size_t component, const std::string& number, std::size_t other_component,
                               const std::string& other_number) {
  return fmt::format("component {} is {}, component {} is {}", component, number, other_component, other_number);
}

std::string part_is(const std::string& part, const std::string& number) {
  return fmt::format("{} is {}", part, number);
}

std::string smallest_eigenvalue_is(const std::string& number) {
  return fmt::format("its smallest eigenvalue is {}", number);
}

std::string column_has_length(std::size_t column, const std::string& length) {
  return fmt::format("column {} has the length {}", column, length);
}

std::string columns_have_product(std::size_t column, std::size_t other_column, const std::string& product) {
  return fmt::format("columns {} and {} have the dot product {}", column, other_column, product);
}

std::string determinant_is(const std::string& number) { return fmt::format("its determinant is {}", number); }

std::string length_is(const std::string& length) { return fmt::format("its length is {}", length); }

std::string product_with_argument_is(const std::string& argument, const std::string& product) {
  return fmt::format("its dot product with {} is {}", argument, product);
}

std::string in_column_it_is(std::size_t column, const std::string& yours, const std::string& right) {
  return fmt::format("in column {} it is {} instead of {}", column, yours, right);
}

}  // namespace workbook::messages
