/// @file
/// What is said when an exercise is put back to the beginning.
#pragma once

#include <string>

namespace workbook::messages {

std::string version_is_kept(const std::string& file);
std::string is_at_the_beginning(const std::string& file);

/// `reason` is the system's, here and below.
std::string not_reset_because_not_kept(const std::string& exercise, const std::string& file, const std::string& reason);
std::string not_reset_because_not_written(const std::string& exercise, const std::string& file);
std::string not_reset(const std::string& exercise, const std::string& reason);

}  // namespace workbook::messages
