/// @file
/// Where a value lacks a property that every right result has. Each is a clause that stands behind "with yours,".
/// Numbers come as texts, with as many digits as are needed; rows and columns are counted from 1.
#pragma once

#include <cstddef>
#include <string>

namespace workbook::messages {

std::string entry_is(std::size_t row, std::size_t col, const std::string& number);
std::string two_entries_are(std::size_t row, std::size_t col, const std::string& number, std::size_t other_row,
                            std::size_t other_col, const std::string& other_number);
std::string two_components_are(std::size_t component, const std::string& number, std::size_t other_component,
                               const std::string& other_number);

/// `part` is what the number is called: "entry (1,3)".
std::string part_is(const std::string& part, const std::string& number);

std::string smallest_eigenvalue_is(const std::string& number);
std::string column_has_length(std::size_t column, const std::string& length);
std::string columns_have_product(std::size_t column, std::size_t other_column, const std::string& product);
std::string determinant_is(const std::string& number);
std::string length_is(const std::string& length);
std::string product_with_argument_is(const std::string& argument, const std::string& product);

/// "it" is the quantity that the property speaks of.
std::string in_column_it_is(std::size_t column, const std::string& yours, const std::string& right);

}  // namespace workbook::messages
