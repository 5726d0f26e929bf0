#include "checker/compile/build_cache.hpp"

#include "checker/messages/compiling.hpp"
#include "checker/messages/machine.hpp"

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <functional>
#include <sstream>
#include <system_error>
#include <vector>

namespace workbook {
namespace fs = std::filesystem;
namespace {

constexpr const char* executable_name = "worker";
constexpr const char* key_name = "key";
constexpr const char* workspace_prefix = "compile-";

std::optional<std::string> content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf())) return std::nullopt;
  return std::move(text).str();
}

/// Notices damage; it need not withstand an enemy, for the key is compared in full.
std::string checksum(const std::string& bytes) {
  return std::to_string(bytes.size()) + " " + std::to_string(std::hash<std::string>{}(bytes)) + "\n";
}

[[noreturn]] void cannot_write(const fs::path& where, const std::string& reason) {
  throw CacheError(messages::cannot_write_to(where.string(), reason));
}

}  // namespace

BuildCache::BuildCache(fs::path directory, std::size_t most_entries)
    : directory_(std::move(directory)), most_entries_(most_entries) {
  std::error_code error;
  fs::create_directories(directory_, error);
  if (error) cannot_write(directory_, error.message());
}

fs::path BuildCache::entry(const std::string& key) const {
  std::ostringstream name;
  name << std::hex << std::hash<std::string>{}(key);
  return directory_ / name.str();
}

std::optional<fs::path> BuildCache::find(const std::string& key) const {
  const fs::path found = entry(key);
  const std::optional<std::string> kept_key = content(found / key_name);
  if (!kept_key || !kept_key->ends_with(key)) return std::nullopt;
  const std::optional<std::string> executable = content(found / executable_name);
  if (!executable || *kept_key != checksum(*executable) + key) return std::nullopt;
  std::error_code ignored;
  fs::last_write_time(found, fs::file_time_type::clock::now(), ignored);
  return found / executable_name;
}

fs::path BuildCache::keep(const fs::path& executable, const std::string& key) const {
  const std::optional<std::string> bytes = content(executable);
  if (!bytes) cannot_write(executable, messages::executable_is_gone());
  const fs::path prepared = executable.parent_path() / "entry";
  std::error_code error;
  fs::create_directory(prepared, error);
  if (!error) fs::rename(executable, prepared / executable_name, error);
  if (error) cannot_write(prepared, error.message());
  std::ofstream stream(prepared / key_name, std::ios::binary);
  if (!(stream << checksum(*bytes) << key).flush()) cannot_write(prepared, messages::disk_may_be_full());
  stream.close();

  const fs::path place = entry(key);
  fs::rename(prepared, place, error);
  if (error) {
    // Somebody made it at the same time: theirs is as good. Otherwise it is a damaged one, and nobody uses that.
    if (const std::optional<fs::path> other = find(key)) return *other;
    std::error_code ignored;
    fs::rename(place, executable.parent_path() / "damaged", ignored);
    fs::rename(prepared, place, error);
    if (error) cannot_write(place, error.message());
  }
  drop_oldest();
  return place / executable_name;
}

void BuildCache::drop_oldest() const {
  struct Entry {
    fs::file_time_type used;
    fs::path path;
  };
  std::vector<Entry> entries;
  std::error_code error;
  const fs::file_time_type now = fs::file_time_type::clock::now();
  for (fs::directory_iterator next(directory_, error), end; !error && next != end; next.increment(error)) {
    std::error_code gone;
    const fs::file_time_type used = fs::last_write_time(next->path(), gone);
    if (gone) continue;
    const bool workspace = next->path().filename().string().starts_with(workspace_prefix);
    if (!workspace) entries.push_back({used, next->path()});
    if (workspace && now - used > std::chrono::hours(1)) fs::remove_all(next->path(), gone);  // of a killed checker
  }
  if (entries.size() <= most_entries_) return;
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
  entries.resize(entries.size() - most_entries_);
  for (const Entry& old : entries) fs::remove_all(old.path, error);
}

Workspace::Workspace(const fs::path& parent) {
  std::string name = (parent / (std::string(workspace_prefix) + "XXXXXX")).string();
  if (!::mkdtemp(name.data())) cannot_write(parent, std::generic_category().message(errno));
  directory_ = name;
}

Workspace::~Workspace() {
  std::error_code ignored;
  fs::remove_all(directory_, ignored);
}

}  // namespace workbook
