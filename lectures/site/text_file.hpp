/// @file
/// Text files read and written whole.
#pragma once

#include <filesystem>
#include <string>

namespace workbook::site {

/// @throws std::runtime_error that calls the file by its shown name when it cannot be read.
std::string read_text(const std::filesystem::path& file, const std::string& shown);

/// @throws std::runtime_error when the file cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace workbook::site
