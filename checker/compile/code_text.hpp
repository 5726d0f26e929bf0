/// @file
/// A student's file as text: its lines, its code without comments, and the place of a column.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace workbook {

/// The text with every comment and everything inside quotation marks turned into spaces, line by line the same size.
std::string code_only(std::string_view source);

/// The lines of a text, without their ends ("\n" or "\r\n").
std::vector<std::string> lines_of(std::string_view text);

/// The line (from 1) in which a byte of the text lies.
int line_of(std::string_view text, std::size_t offset);

/// Compilers count columns as terminals show them, from 1, with a tab stop every eight.
inline constexpr int tab_stop = 8;

/// The byte of a line that is shown in a column; the size of the line if the column lies behind its end.
std::size_t byte_at_column(std::string_view line, int column);

/// The column in which a byte of a line is shown.
int column_of(std::string_view line, std::size_t offset);

/// A line of the student's file, and below it a caret at the column (none if the column is 0): tabs as spaces, safe to
/// print, and only the part around the caret where the line is long.
std::string excerpt(std::string_view line, int column);

}  // namespace workbook
