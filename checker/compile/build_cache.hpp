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

/// A directory of entries, each a directory with an executable and the whole key that it was made from. Entries appear
/// and disappear at once (by renaming), so several checkers may share a cache. A damaged entry counts as absent.
class BuildCache {
 public:
  /// @throws CacheError if the directory cannot be made
  explicit BuildCache(std::filesystem::path directory, std::size_t most_entries = 200);

  /// The executable that was made from exactly this key.
  std::optional<std::filesystem::path> find(const std::string& key) const;

  /// Takes the executable, a file in a directory on the same file system, into the cache; drops what was not used for
  /// longest. Returns where it is now. @throws CacheError
  std::filesystem::path keep(const std::filesystem::path& executable, const std::string& key) const;

  const std::filesystem::path& directory() const { return directory_; }

 private:
  std::filesystem::path entry(const std::string& key) const;
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
