/// @file
/// Text from a student's process or file, made safe to show on a terminal and to put into JSON.
#pragma once

#include <string>
#include <string_view>

namespace workbook {

/// Valid UTF-8 without control characters: what is neither becomes "?"; line ends and tabs stay.
std::string printable(std::string_view text);

}  // namespace workbook
