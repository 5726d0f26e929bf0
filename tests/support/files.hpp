/// @file
/// Files and programs as tests handle them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace workbook::testing {

std::string read(const std::filesystem::path& file);
/// Returns the file. @throws if it cannot be written
std::filesystem::path write(const std::filesystem::path& file, const std::string& text);

/// Replaces the first `from` in the file. @throws if it is not there, so that a test cannot go stale unseen.
void replace_in(const std::filesystem::path& file, const std::string& from, const std::string& to);

/// Does the text contain the part?
bool has(const std::string& text, const std::string& part);

/// All ordinary files below a folder.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

/// The exit status of a shell's command, or -1 if a signal ended it.
int run_in_shell(const std::string& command);

}  // namespace workbook::testing
