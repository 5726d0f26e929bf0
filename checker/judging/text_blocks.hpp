/// @file
/// Laying out numbers in aligned columns.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace workbook {

/// The width of a page for a terminal of 80 columns with a margin.
inline constexpr std::size_t page_width = 78;

/// What text is laid out on.
struct Page {
  std::size_t width = page_width;  ///< all text keeps to it where its numbers let it
  bool is_linear = false;          ///< nothing beside each other: for screen readers
};

/// The mark in front of every number that is not within the tolerance.
inline constexpr const char* differing_mark = "≠";

/// How many columns the widest line takes.
std::size_t widest(const std::vector<std::string>& lines);

/// Lines of text below a title.
struct Block {
  std::string title;
  std::vector<std::string> lines;
};

/// Numbers in rows and columns, perhaps with marks in front of them.
struct Table {
  std::vector<std::string> headings;           ///< one per column of numbers, or none
  std::vector<std::string> labels;             ///< one per row, or none
  std::vector<std::vector<std::string>> rows;  ///< numbers, aligned on the decimal point column by column
  std::vector<std::string> endings;            ///< one per row, or none: units
  /// True where a number is to be marked; without it there is no room for marks.
  std::function<bool(std::size_t row, std::size_t col)> is_marked;
};

void append(std::vector<std::string>& lines, std::vector<std::string> more);

std::vector<std::string> indented(std::vector<std::string> lines, std::size_t depth);

/// " [kg m²]", or nothing for a pure number.
std::string in_brackets(const std::string& unit);

/// Every entry below its column's heading; no line ends with a blank.
std::vector<std::string> table_lines(const Table& table);

/// Blocks beside each other as long as they fit on the page, each row of blocks below the one before.
std::vector<std::string> side_by_side(const std::vector<Block>& blocks, std::size_t indent, const Page& page = {});

/// Texts in columns of one width, as many beside each other as fit on the page.
std::vector<std::string> wrapped_in_columns(const std::vector<std::string>& texts, std::size_t indent,
                                            const Page& page = {});

/// Lines of whole words that fit on the page.
std::vector<std::string> wrapped(const std::string& sentence, std::size_t indent, const Page& page = {});

}  // namespace workbook
