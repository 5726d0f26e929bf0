/// @file
/// A file that somebody handed in, read once: anything may stand under its name.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace workbook {

/// The file cannot be source code: one sentence for the student.
struct RejectedFile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr std::size_t largest_source = std::size_t{1} << 20;

/// What is compiled, explained, fingerprinted and reported is this text, whatever happens to the file meanwhile.
struct Submission {
  std::filesystem::path path;
  std::string shown_name;  ///< as seen from the current folder; safe to print, on one line
  std::string text;
  /// Own functions of earlier exercises that the text names, each called as its file: those that it calls are linked to
  /// it.
  std::vector<Submission> library = {};
  /// Names of other functions of the course that the text defines itself, for a helper: in this file its own one counts.
  std::vector<std::string> own_names = {};
};

/// Reads a regular file of at most largest_source bytes. Never waits, whatever it is; follows no symbolic link, for a
/// submission must not reach other files.
/// @param shown_name  what messages call it; empty: its path as seen from the current folder. @throws RejectedFile
Submission read_submission(const std::filesystem::path& path, const std::string& shown_name = "");

}  // namespace workbook
