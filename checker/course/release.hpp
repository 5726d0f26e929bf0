/// @file
/// Releases of the copy for students: what each holds, what has changed, and how a copy gets from one to the next.
#pragma once

#include "checker/course/course.hpp"

namespace workbook {

struct ReleaseChange {
  int release = 1;
  std::string date;
  std::string message;             ///< the instructor's words; may be empty
  std::vector<std::string> files;  ///< added, changed or removed
};

/// What `.release.json` at the top level of a copy says.
struct Release {
  int number = 1;
  std::uint64_t seed = 1;
  std::map<std::string, std::string> files;  ///< all that was handed out, and the fingerprint of each
  std::vector<ReleaseChange> changes;        ///< since the first release, oldest first
};

/// Copies a file, not a symbolic link, and makes its folder: the whole of it or nothing. @throws UsageError
void place_file(const fs::path& from, const fs::path& to);

/// @throws UsageError
Release read_release(const fs::path& copy);

/// Writes `.release.json` for all files of a new copy. @param before  the release that it follows, if any
/// @throws std::runtime_error
Release write_release(const fs::path& copy, std::uint64_t seed, const std::string& date, const std::string& message,
                      const std::optional<Release>& before);

/// What an update did with files that were changed in the copy.
struct UpdateResult {
  std::size_t written = 0;
  std::vector<std::string> own;   ///< exercises that the new release changes: the copy's files stay as they are
  std::vector<std::string> kept;  ///< other files: the copy's own version lies below .workbook/kept now
};

/// Brings a copy from the release that it has been to the one in another folder. Exercises that were worked on, and
/// files that were never handed out, are not touched. Nothing is written where a file of the release is missing or not
/// what its fingerprint says, or where a symbolic link would be followed. If it is stopped, the next call goes on.
/// @throws UsageError saying what was done
UpdateResult update_copy(const fs::path& from, const Release& now, const fs::path& copy, const Release& before);

}  // namespace workbook
