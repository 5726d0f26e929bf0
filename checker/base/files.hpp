/// @file
/// Reading and writing whole files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace workbook {

/// The content of a regular file, nothing if there is none, it cannot be read or is larger than `limit`.
std::optional<std::string> read_file(const std::filesystem::path& file, std::size_t limit = std::size_t{1} << 30);

/// Written under another name and renamed, so that nobody reads half a file. Makes the folder if need be.
/// @returns "" or the system's reason
std::string write_file(const std::filesystem::path& file, std::string_view content);

/// The fingerprint of a file's content; "" if it cannot be read.
std::string file_fingerprint(const std::filesystem::path& file);

/// FILE itself, or the first of FILE.2, FILE.3, … that is not taken.
std::filesystem::path free_name(const std::filesystem::path& file);

/// As seen from the current folder, safe to print.
std::string shown_path(const std::filesystem::path& file);

/// Where a program lies on PATH; "" if it is not installed.
std::string program_on_path(const std::string& name);

}  // namespace workbook
