/// @file
/// Reading a file that somebody handed in: anything may stand under its name.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace workbook {

/// The file cannot be source code: one sentence for the student.
struct RejectedFile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr std::size_t largest_source = std::size_t{1} << 20;

/// The text of a regular file of at most largest_source bytes, without a byte order mark. Never waits, whatever it is.
/// Symbolic links are not followed: a submission must not reach other files.
/// @throws RejectedFile
std::string read_source(const std::filesystem::path& file);

}  // namespace workbook
