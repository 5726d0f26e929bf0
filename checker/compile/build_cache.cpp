#include "checker/compile/compile.hpp"

#include "checker/base/text.hpp"

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <sstream>

namespace workbook {
namespace fs = std::filesystem;
namespace {

constexpr const char* executable_name = "worker";
constexpr const char* seal_name = "made_from";
constexpr const char* workspace_prefix = "compile-";

/// The key, and what notices a damaged executable. It need not withstand an attacker.
std::string sealed(const std::string& key, const std::string& executable) {
  return fmt::format("format 2 {} {:x} {}\n{}\n", executable.size(), std::hash<std::string>{}(executable), key.size(),
                     key);
}

[[noreturn]] void cannot_write(const fs::path& where, const std::string& reason) {
  throw std::runtime_error(
      fmt::format("The checker cannot write to {} ({}); this is not your mistake.", where.string(), reason));
}

}  // namespace

BuildCache::BuildCache(fs::path directory, std::size_t most_entries)
    : directory_(std::move(directory)), most_entries_(most_entries) {
  std::error_code error;
  fs::create_directories(directory_, error);
  if (error) cannot_write(directory_, error.message());
}

std::optional<Compilation> BuildCache::find(const std::string& key) const {
  const fs::path entry = directory_ / fingerprint(key);
  const Program program(entry / executable_name);  // before it is looked at: it may be dropped meanwhile
  const std::optional<std::string> seal = read_file(entry / seal_name);
  const std::optional<std::string> executable = read_file(entry / executable_name);
  if (!seal || !executable || !*program.opened) return std::nullopt;
  const std::string expected = sealed(key, *executable);
  if (!seal->starts_with(expected)) return std::nullopt;
  std::error_code ignored;
  fs::last_write_time(entry, fs::file_time_type::clock::now(), ignored);
  // One line with the functions that were linked, then the compiler's output.
  const std::size_t end_of_line = std::min(seal->find('\n', expected.size()), seal->size());
  std::istringstream names(seal->substr(expected.size(), end_of_line - expected.size()));
  return Compilation{.executable = program.file,
                     .opened = program.opened,
                     .compiler_output = seal->substr(std::min(end_of_line + 1, seal->size())),
                     .linked = {std::istream_iterator<std::string>(names), {}}};
}

Compilation BuildCache::keep(Compilation built, const std::string& key) const {
  const fs::path executable = *built.executable;
  const std::optional<std::string> bytes = read_file(executable);
  if (!bytes) cannot_write(executable, "the executable is gone");
  built.opened = Program(executable).opened;
  const fs::path prepared = executable.parent_path() / "entry";
  const std::string problem =
      write_file(prepared / seal_name,
                 fmt::format("{}{}\n{}", sealed(key, *bytes), fmt::join(built.linked, " "), built.compiler_output));
  if (!problem.empty()) cannot_write(prepared, problem);
  std::error_code error;
  // Other users may run it, whatever the umask: see become_unique_user().
  fs::permissions(executable, fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add, error);
  if (!error) fs::rename(executable, prepared / executable_name, error);
  if (error) cannot_write(prepared, error.message());

  const fs::path place = directory_ / fingerprint(key);
  fs::rename(prepared, place, error);
  if (error) {
    // Somebody made it at the same time: theirs is as good. Otherwise it is a damaged one, and nobody uses that.
    if (const std::optional<Compilation> other = find(key)) return *other;
    fs::rename(place, executable.parent_path() / "damaged", error);
    fs::rename(prepared, place, error);
    if (error) cannot_write(place, error.message());
  }
  drop_oldest();
  built.executable = place / executable_name;
  return built;
}

void BuildCache::drop_oldest() const {
  std::vector<std::pair<fs::file_time_type, fs::path>> entries;
  std::error_code error;
  const fs::file_time_type now = fs::file_time_type::clock::now();
  for (fs::directory_iterator next(directory_, error), end; !error && next != end; next.increment(error)) {
    std::error_code gone;
    const fs::file_time_type used = fs::last_write_time(next->path(), gone);
    const bool is_workspace = next->path().filename().string().starts_with(workspace_prefix);
    if (!gone && !is_workspace) entries.emplace_back(used, next->path());
    // Of a checker that was killed.
    if (!gone && is_workspace && now - used > std::chrono::hours(1)) fs::remove_all(next->path(), gone);
  }
  std::ranges::sort(entries);
  for (std::size_t i = 0; i + most_entries_ < entries.size(); ++i) fs::remove_all(entries[i].second, error);
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
