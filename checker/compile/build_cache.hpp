/// @file
/// Executables that were made before, so that an unchanged file need not be compiled again.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

namespace workbook {

/// The cache's directory cannot be written to.
struct CacheError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What came of a compilation.
struct BuiltProgram {
  std::filesystem::path executable;
  std::string compiler_output;
};

/// A directory of entries, each a directory with an executable and all that it was made from. Entries appear and
/// disappear at once (by renaming), so several checkers may share a cache. A damaged entry counts as absent.
class BuildCache {
 public:
  /// @throws CacheError if the directory cannot be made
  explicit BuildCache(std::filesystem::path directory, std::size_t most_entries = 200);

  /// What was made from exactly this key.
  std::optional<BuiltProgram> find(const std::string& key) const;

  /// Takes the executable, a file in a directory on the same file system, into the cache; drops what was not used for
  /// longest. Returns where it is now. @throws CacheError
  BuiltProgram keep(const BuiltProgram& built, const std::string& key) const;

  const std::filesystem::path& directory() const { return directory_; }

 private:
  void drop_oldest() const;

  std::filesystem::path directory_;
  std::size_t most_entries_;
};

/// A new private directory, removed with all it holds at the end.
class Workspace {
 public:
  /// @throws CacheError
  explicit Workspace(const std::filesystem::path& parent);
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  const std::filesystem::path& directory() const { return directory_; }

 private:
  std::filesystem::path directory_;
};

}  // namespace workbook
