/// @file
/// Numbers in aligned columns.
#pragma once

#include "checker/data/value.hpp"
#include "checker/report/failure_text.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace workbook {

using Lines = std::vector<std::string>;

/// Numbers in rows and columns, those outside the tolerance with a mark in front.
struct Table {
  Lines headings;           ///< one per column of numbers, or none
  Lines labels;             ///< one per row, or none
  std::vector<Lines> rows;  ///< numbers, aligned on the decimal point column by column
  Lines endings;            ///< one per row, or none: units
  std::function<bool(std::size_t row, std::size_t col)> is_marked;  ///< without it there is no room for marks

  /// Every entry below its column's heading; no line ends with a blank.
  Lines lines() const;
};

/// True for a number of a value that is to be marked.
using NumberTest = std::function<bool(std::size_t number)>;

/// The columns [first_col, first_col + 3) of a value of three rows.
Table matrix_table(const Value& value, std::size_t first_col, int digits, const NumberTest& is_marked = {});

/// Lines below a title.
struct Block {
  std::string title;
  Lines lines;
};

/// Blocks beside each other as long as they fit on the page, each row of blocks below the one before.
Lines side_by_side(const std::vector<Block>& blocks, std::size_t indent, const Page& page);

/// Texts in columns of one width, as many beside each other as fit on the page.
Lines wrapped_in_columns(const Lines& texts, std::size_t indent, const Page& page);

std::size_t widest(const Lines& lines);
Lines indented(Lines lines, std::size_t depth);
void append(Lines& lines, Lines more);

}  // namespace workbook
