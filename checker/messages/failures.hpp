/// @file
/// The words around the numbers of a case that failed, and what the numbers of a value are called.
#pragma once

#include <cstddef>
#include <string>

namespace workbook::messages {

// --- headings

std::string case_heading(const std::string& case_name);
std::string inputs_heading();

/// `unit` stands in brackets with a blank in front, or is empty; here and below.
std::string result_heading(const std::string& result, const std::string& unit);
std::string points_heading(const std::string& argument, const std::string& unit);
std::string expected_heading();
std::string yours_heading();
std::string difference_heading();

// --- parts of a value; all counted from 1

/// A value that is one number.
std::string the_result();
std::string component(std::size_t number);
std::string entry(std::size_t row, std::size_t col);
std::string entry_of_matrix(std::size_t row, std::size_t col, std::size_t matrix);
std::string column(std::size_t number);
std::string matrix(std::size_t number);

// --- what is not shown

std::string no_number();
std::string empty_list();
std::string no_value_to_show();
std::string more_numbers(std::size_t count);
std::string more_columns(std::size_t count);
std::string other_numbers_agree(std::size_t count);

// --- how an answer is measured

std::string expected_up_to_sign();

/// What the entries of a difference are, in a formula.
std::string yours_minus_expected();
std::string attitude_minus_expected();

/// `formula` is a difference that vanishes for a right answer.
std::string zero_for_a_right_answer(const std::string& formula);

/// Stands before the number.
std::string column_is_off_by(std::size_t column);

}  // namespace workbook::messages
