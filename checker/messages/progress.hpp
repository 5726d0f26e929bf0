/// @file
/// Trouble with the file that remembers what a student has done.
#pragma once

#include <string>

namespace workbook::messages {

std::string damaged_progress_set_aside(const std::string& aside);
std::string damaged_progress_stays(const std::string& file);
std::string progress_not_saved(const std::string& file);

}  // namespace workbook::messages
