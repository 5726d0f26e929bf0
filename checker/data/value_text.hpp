/// @file
/// Numbers and values as people read them.
#pragma once

#include "checker/data/value.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace workbook {

/// The shortest text that reads back as the same number.
inline constexpr int all_digits = 0;

/// The number with at most that many significant digits, or with all_digits.
std::string number_text(double number, int digits);

/// Two numbers with as few digits as tell them apart, and at least `digits`.
std::pair<std::string, std::string> distinct_texts(double one, double other, int digits);

/// How many significant digits show where two numbers differ, between 6 and 17.
int digits_to_tell_apart(double one, double other);

/// "1/2", "−1", "0": a simple fraction if the number is one within 1e-6, else four digits.
std::string coefficient_text(double coefficient);

/// The value on one line: "4.82", "(0.3, -0.2, 0.5)", "[26 -3 -4.5; -3 20 -9; -4.5 -9 10]".
std::string format_value(const Value& value, Kind kind, int digits = all_digits);

/// What one of the value's numbers is called: "the result", "component 2", "entry (1,3)", "entry (1,3) of matrix 2".
std::string entry_name(const Value& value, Kind kind, std::size_t number);

/// Texts of one width, with their decimal points below each other.
std::vector<std::string> aligned_on_point(const std::vector<std::string>& numbers);

}  // namespace workbook
