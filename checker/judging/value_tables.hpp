/// @file
/// Values as tables of numbers, for a page of text.
#pragma once

#include "checker/data/value.hpp"
#include "checker/judging/text_blocks.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace workbook {

/// Of a long list so many rows are shown; the checker's JSON has them all.
inline constexpr std::size_t most_rows = 24;

/// True for a number of a value that is to be marked.
using NumberTest = std::function<bool(std::size_t number)>;

/// The columns [first_col, first_col + 3) of a value of three rows. Without a test there is no room for marks.
Table matrix_table(const Value& value, std::size_t first_col, int digits, const NumberTest& is_marked = {});

/// The first columns of a value, each on a line of its own: a list of points reads better so, and fits on the page.
Table columns_table(const Value& value, std::size_t count);

}  // namespace workbook
