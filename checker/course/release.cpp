#include "checker/course/release.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace workbook {

using nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ReleaseChange, release, date, message, files)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Release, number, seed, files, changes)

namespace {

constexpr const char* release_name = ".release.json";

/// Students' own work, once it differs from what was handed out.
bool is_exercise(const fs::path& file) {
  return file.extension() == ".cpp" && file.parent_path().filename() == "exercises";
}

bool is_inside(const std::string& file) {
  const fs::path path(file);
  return !file.empty() && path.is_relative() && path.lexically_normal() == path && *path.begin() != "..";
}

}  // namespace

void place_file(const fs::path& from, const fs::path& to) {
  std::error_code problem;
  fs::create_directories(to.parent_path(), problem);
  // Under another name first, so that there is never half a file.
  const fs::path unfinished = to.string() + ".unfinished";
  fs::copy_file(from, unfinished, fs::copy_options::overwrite_existing, problem);
  if (!problem) fs::rename(unfinished, to, problem);
  if (problem) throw UsageError(fmt::format("{} cannot be written ({}).", shown_path(to), problem.message()));
}

Release read_release(const fs::path& copy) {
  const fs::path file = copy / release_name;
  const std::optional<std::string> text = read_file(file);
  if (!text)
    throw UsageError(fmt::format("{} is no copy that `handout` wrote: it has no {}.", shown_path(copy), release_name));
  try {
    Release release = json::parse(*text).get<Release>();
    for (const auto& [name, content] : release.files)
      if (!is_inside(name)) throw std::runtime_error(fmt::format("'{}' lies outside", printable(name)));
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
      if ((!before->files.contains(file) || before->files.at(file) != content) && !file.ends_with(".locked"))
        change.files.push_back(file);  // locked texts get another key every time
    for (const auto& [file, content] : before->files)
      if (!release.files.contains(file)) change.files.push_back(file);
    release.changes = before->changes;
    release.changes.push_back(change);
  }
  write_or_throw(copy / release_name, json(release).dump(1) + "\n");
  return release;
}

UpdateResult update_copy(const fs::path& from, const Release& now, const fs::path& copy, const Release& before) {
  UpdateResult result;
  std::error_code ignored;
  const auto has = [](const Release& release, const std::string& file, const std::string& content) {
    const auto found = release.files.find(file);
    return found != release.files.end() && found->second == content;
  };
  for (const auto& [file, wanted] : now.files) {
    const std::string present = file_fingerprint(copy / file);
    if (present == wanted) continue;
    const bool is_own = !present.empty() && !has(before, file, present);
    if (is_own && is_exercise(file)) {
      if (!has(before, file, wanted)) result.own.push_back(file);
      continue;
    }
    if (is_own && has(before, file, wanted)) continue;  // changed here only
    if (is_own) {
      const fs::path kept = free_name(copy / ".workbook/kept" / file);
      place_file(copy / file, kept);
      result.kept.push_back(kept.lexically_relative(copy).string());
    }
    place_file(from / file, copy / file);
    ++result.written;
  }
  for (const auto& [file, content] : before.files)
    if (!now.files.contains(file) && file_fingerprint(copy / file) == content) fs::remove(copy / file, ignored);
  place_file(from / release_name, copy / release_name);
  return result;
}

}  // namespace workbook
