#include "checker/course/release.hpp"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <set>

namespace workbook {

using nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ReleaseChange, release, date, message, files)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Release, number, seed, files, changes)

namespace {

constexpr const char* release_name = ".release.json";

std::string text_of(const Release& release) { return json(release).dump(1) + "\n"; }

/// Students' own work, once it differs from what was handed out.
bool is_exercise(const fs::path& file) {
  return file.extension() == ".cpp" && file.parent_path().filename() == "exercises";
}

/// Below the top level, and where nothing but a workbook looks: .git would hold programs that git starts.
bool is_allowed(const std::string& file) {
  const fs::path path(file);
  if (file.empty() || !path.is_relative() || path.lexically_normal() != path || !path.has_filename()) return false;
  const std::set<std::string> known = {".github", ".vscode", ".devcontainer"};
  const auto is_known = [&](const fs::path& folder) {
    return !folder.string().starts_with('.') || known.contains(folder.string());
  };
  const fs::path folders = path.parent_path();
  return path.filename() != ".git" && std::all_of(folders.begin(), folders.end(), is_known);
}

/// A file as it lies in a folder.
struct Found {
  std::string text;
  mode_t mode = 0;
};

/// Follows no link on the way. @throws UsageError
Found read_inside(const fs::path& folder, const fs::path& file) {
  Descriptor opened(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  for (auto part = file.begin(); opened && part != file.end(); ++part) {
    const int kind = std::next(part) == file.end() ? O_RDONLY | O_NONBLOCK : O_PATH | O_DIRECTORY;
    opened = Descriptor(::openat(opened.number(), part->c_str(), kind | O_NOFOLLOW | O_CLOEXEC));
  }
  Found found;
  struct stat status {};
  const bool is_there = opened && ::fstat(opened.number(), &status) == 0;
  const char* const reason = is_there ? "it is no ordinary file" : std::strerror(errno);
  if (!is_there || !S_ISREG(status.st_mode))
    throw UsageError(fmt::format("{} cannot be read ({}).", shown_path(folder / file), reason));
  std::array<char, 1 << 16> block{};
  for (ssize_t got = 0; (got = ::read(opened.number(), block.data(), block.size())) > 0;)
    found.text.append(block.data(), static_cast<std::size_t>(got));
  found.mode = status.st_mode & 0777;
  return found;
}

/// The first part of the way to a file that is a symbolic link; empty: none.
fs::path link_on_the_way(const fs::path& folder, const fs::path& file) {
  std::error_code ignored;
  fs::path way = folder;
  for (const fs::path& part : file) {
    way /= part;
    if (fs::is_symlink(fs::symlink_status(way, ignored))) return way;
  }
  return {};
}

/// One file that an update writes.
struct Planned {
  std::string file;
  Found content;
  fs::path kept;  ///< where the copy's own version goes first; empty: it has none
};

/// What is to be written, all of it read and compared. @throws UsageError
std::vector<Planned> planned_update(const fs::path& from, const Release& now, const fs::path& copy,
                                    const Release& before, UpdateResult& result) {
  const auto has = [](const Release& release, const std::string& file, const std::string& content) {
    const auto found = release.files.find(file);
    return found != release.files.end() && found->second == content;
  };
  std::vector<Planned> plan;
  for (const auto& [file, wanted] : now.files) {
    Planned next{file, read_inside(from, file), {}};
    if (fingerprint(next.content.text) != wanted)
      throw UsageError(fmt::format("{} is not the file that this release holds; unpack the release again.",
                                   shown_path(from / file)));
    const std::string present = file_fingerprint(copy / file);
    if (present == wanted) continue;
    const bool is_own = !present.empty() && !has(before, file, present);
    if (is_own && is_exercise(file)) {
      if (!has(before, file, wanted)) result.own.push_back(file);
      continue;
    }
    if (is_own && has(before, file, wanted)) continue;  // changed here only
    if (is_own) next.kept = fs::path(".workbook/kept") / file;
    for (const fs::path& written : {fs::path(file), next.kept})
      if (const fs::path link = link_on_the_way(copy, written); !link.empty())
        throw UsageError(
            fmt::format("{} is a symbolic link, behind which nothing is written; put the file or folder "
                        "itself there.",
                        shown_path(link)));
    plan.push_back(std::move(next));
  }
  return plan;
}

/// @throws UsageError
void write_found(const fs::path& file, const Found& content) {
  const std::string trouble = write_file(file, content.text, static_cast<fs::perms>(content.mode));
  if (!trouble.empty()) throw UsageError(fmt::format("{} cannot be written ({}).", shown_path(file), trouble));
}

}  // namespace

void place_file(const fs::path& from, const fs::path& to) {
  write_found(to, read_inside(fs::absolute(from).parent_path(), from.filename()));
}

Release read_release(const fs::path& copy) {
  const fs::path file = copy / release_name;
  const std::optional<std::string> text = read_file(file);
  if (!text)
    throw UsageError(fmt::format("{} is no copy that `handout` wrote: it has no {}.",
                                 shown_path(copy) == "." ? "This workbook" : shown_path(copy), release_name));
  try {
    Release release = json::parse(*text).get<Release>();
    for (const auto& [name, content] : release.files)
      if (!is_allowed(name))
        throw std::runtime_error(fmt::format("'{}' lies where no file of a release does", printable(name)));
    return release;
  } catch (const std::exception& problem) {
    throw UsageError(
        fmt::format("{} is damaged ({}).", shown_path(file), without_full_stop(printable(problem.what()))));
  }
}

Release write_release(const fs::path& copy, std::uint64_t seed, const std::string& date, const std::string& message,
                      const std::optional<Release>& before) {
  Release release{before ? before->number + 1 : 1, seed, {}, {}};
  for (const auto& entry : fs::recursive_directory_iterator(copy))
    if (entry.is_regular_file())
      release.files[entry.path().lexically_relative(copy).string()] = file_fingerprint(entry.path());
  if (before) {
    ReleaseChange change{release.number, date, message, {}};
    for (const auto& [file, content] : release.files)
      if (!before->files.contains(file) || before->files.at(file) != content) change.files.push_back(file);
    for (const auto& [file, content] : before->files)
      if (!release.files.contains(file)) change.files.push_back(file);
    release.changes = before->changes;
    release.changes.push_back(change);
  }
  write_or_throw(copy / release_name, text_of(release));
  return release;
}

UpdateResult update_copy(const fs::path& from, const Release& now, const fs::path& copy, const Release& before) {
  remove_unfinished(copy);  // by an update that was killed
  UpdateResult result;
  const std::vector<Planned> plan = planned_update(from, now, copy, before, result);
  try {
    for (const Planned& each : plan) {
      if (!each.kept.empty()) {
        const fs::path kept = free_name(copy / each.kept);
        place_file(copy / each.file, kept);
        result.kept.push_back(kept.lexically_relative(copy).string());
      }
      write_found(copy / each.file, each.content);
      ++result.written;
    }
    std::error_code ignored;
    for (const auto& [file, content] : before.files)
      if (!now.files.contains(file) && link_on_the_way(copy, file).empty() && file_fingerprint(copy / file) == content)
        fs::remove(copy / file, ignored);
    write_found(copy / release_name, {text_of(now), 0644});
  } catch (const UsageError& problem) {
    throw UsageError(fmt::format("{} {} of {} are new already, the rest is as it was; the same command goes on.",
                                 problem.what(), result.written, plural(plan.size(), "file")));
  }
  return result;
}

}  // namespace workbook
