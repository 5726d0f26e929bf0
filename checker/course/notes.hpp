/// @file
/// What the notes call their paragraphs.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace workbook {

/// The headings of a lecture's notes by their anchors: "steiner" → "The theorem of Steiner". Empty if the file cannot
/// be read: a heading is a help, and the anchor does as well.
std::map<std::string, std::string> read_headings(const std::filesystem::path& notes);

}  // namespace workbook
