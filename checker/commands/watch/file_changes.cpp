#include "checker/commands/watch/watch.hpp"

#include <sys/inotify.h>

#include <algorithm>

namespace workbook {

using std::chrono::milliseconds;

namespace {

constexpr milliseconds between_looks{1000};
constexpr milliseconds between_looks_without_events{250};
// A look may hit the middle of a slow write: whoever writes gets the time for the next piece.
constexpr milliseconds for_the_next_piece{60};
// Editors that replace a file leave it empty or absent for a moment.
constexpr milliseconds for_emptiness{250};
// A file that never stops changing is read all the same.
constexpr milliseconds longest_wait{1000};
// The coarsest times of modification in use: two seconds, on FAT.
constexpr std::int64_t time_resolution = 3;

}  // namespace

FileChanges::Stamp FileChanges::stamp_of(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return {};
  return {status.st_ctim.tv_sec,  status.st_ctim.tv_nsec, status.st_mtim.tv_sec,
          status.st_mtim.tv_nsec, status.st_size,         static_cast<std::int64_t>(status.st_ino)};
}

FileChanges::FileChanges(const std::vector<fs::path>& files, bool with_events) {
  if (with_events) events_ = Descriptor(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
  if (!events_)
    events_missing_ = with_events ? "inotify: " + std::generic_category().message(errno) : "WORKBOOK_POLL is set";
  for (const fs::path& path : files) {
    if (std::ranges::find(folders_, path.parent_path()) == folders_.end()) folders_.push_back(path.parent_path());
    files_.emplace_back().path = path;
  }
  find_folders();  // before reading, so that no change falls between
  for (File& file : files_) read(file, stamp_of(file.path));
}

/// Listening once more to a folder that is listened to changes nothing; one that was made anew is listened to again.
void FileChanges::find_folders() {
  missing_.clear();
  for (const fs::path& folder : folders_) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) {
      missing_.push_back(folder);
    } else if (events_ &&
               ::inotify_add_watch(events_.number(), folder.c_str(),
                                   IN_CLOSE_WRITE | IN_MOVE | IN_CREATE | IN_DELETE | IN_ONLYDIR) < 0 &&
               errno != ENOENT && errno != ENOTDIR && errno != EACCES) {
      // The limit of watches, most likely. Watching only some folders would be inconsistent: fall back to polling.
      events_missing_ = "inotify: " + std::generic_category().message(errno);
      events_.close();
    }
  }
}

bool FileChanges::drain_events() const {
  std::array<char, 16384> buffer;
  bool any = false;
  while (events_ && ::read(events_.number(), buffer.data(), buffer.size()) > 0) any = true;
  return any;
}

/// True if the content is new. The stamp is older than the content: what changes meanwhile changes the stamp once more.
bool FileChanges::read(File& file, const Stamp& stamp) {
  const std::int64_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  file.stamp = file.seen = stamp;
  file.since.reset();
  file.is_recent = std::abs(now - std::max(stamp[0], stamp[2])) <= time_resolution;
  const std::string before = std::exchange(file.fingerprint, file_fingerprint(file.path));
  return file.fingerprint != before;
}

std::vector<std::size_t> FileChanges::collect() {
  const Clock::time_point now = Clock::now();
  const bool has_event = drain_events();
  if (!has_event && now < next_look_) return {};
  next_look_ = now + (events_ ? between_looks : between_looks_without_events);
  find_folders();
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    File& file = files_[i];
    if (std::ranges::find(missing_, file.path.parent_path()) != missing_.end()) continue;
    const Stamp stamp = stamp_of(file.path);
    if (stamp == file.stamp && !file.is_recent) {
      file.since.reset();
      continue;
    }
    if (!file.since) file.since = now;
    const auto waited = now - *file.since;
    const bool is_empty = stamp[4] == 0;  // or absent
    const bool is_steady = std::exchange(file.seen, stamp) == stamp || has_event;
    if (waited >= longest_wait || (is_steady && (!is_empty || waited >= for_emptiness))) {
      if (read(file, stamp)) changed.push_back(i);
    } else {
      next_look_ = std::min(next_look_, now + for_the_next_piece);
    }
  }
  std::ranges::stable_sort(changed, {}, [&](std::size_t i) { return files_[i].stamp; });
  return changed;
}

}  // namespace workbook
