/// @file
/// The ways in which editors save a file.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace workbook::testing {

enum class Way {
  directly,        ///< truncated and written
  in_pieces,       ///< truncated, then written slowly
  in_many_writes,  ///< opened and closed for every piece
  by_renaming,     ///< written under another name, which is then given to the file
  with_backup      ///< the old file gets another name, then a new one is written
};

inline constexpr Way all_ways[] = {Way::directly, Way::in_pieces, Way::in_many_writes, Way::by_renaming,
                                   Way::with_backup};

const char* to_string(Way way);

/// @param pause  what is done between two steps of a slow way
void save(const std::filesystem::path& file, const std::string& text, Way way, const std::function<void()>& pause);

/// Saves with short pauses.
void save(const std::filesystem::path& file, const std::string& text, Way way = Way::directly);

}  // namespace workbook::testing
