#include "checker/watch/file_changes.hpp"

#include "checker/course/progress.hpp"

#include <sys/inotify.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <system_error>

namespace workbook {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

namespace {

// Long enough for the second of two writes in a row, too short to be felt.
constexpr milliseconds after_closing{15};
// A look may hit the middle of a slow write: whoever writes gets the time for the next piece.
constexpr milliseconds after_a_look{60};
// Editors that replace a file leave it empty or absent for a moment.
constexpr milliseconds for_emptiness{250};
// A file that never stops changing is read all the same.
constexpr milliseconds longest_wait{1000};

constexpr milliseconds between_looks{1000};
constexpr milliseconds between_looks_without_events{250};

// The coarsest times of modification in use: two seconds, on FAT.
constexpr std::chrono::seconds time_resolution{3};

constexpr std::uint32_t of_interest =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_CREATE | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

std::chrono::nanoseconds duration(const timespec& time) {
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

bool is_recent(const FileStamp& stamp) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto age = std::chrono::duration_cast<std::chrono::nanoseconds>(now) - stamp.modified;
  return stamp.exists && age < time_resolution && age > -time_resolution;
}

}  // namespace

FileStamp stamp_of(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return {};
  return {true, status.st_ino, status.st_size, duration(status.st_mtim), duration(status.st_ctim)};
}

FileChanges::FileChanges(std::vector<fs::path> files, Events events) {
  for (fs::path& path : files) {
    const fs::path parent = path.parent_path();
    const auto known =
        std::find_if(folders_.begin(), folders_.end(), [&](const Folder& folder) { return folder.path == parent; });
    File file;
    file.folder = static_cast<std::size_t>(known - folders_.begin());
    if (known == folders_.end()) folders_.push_back({parent, -1, false});
    file.path = std::move(path);
    files_.push_back(std::move(file));
  }
  if (events == Events::wanted) {
    events_ = Descriptor(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
    if (!events_) trouble_ = std::generic_category().message(errno);
  }
  add_watches();  // before reading, so that no change falls between
  for (File& file : files_) read(file);
  next_poll_ = Clock::now() + (events_ ? between_looks : between_looks_without_events);
}

void FileChanges::add_watches() {
  for (Folder& folder : folders_) {
    std::error_code ignored;
    folder.missing = !fs::is_directory(folder.path, ignored);
    if (folder.missing && folder.watch >= 0) {  // a folder above it was moved away: what comes back may be another
      ::inotify_rm_watch(events_.number(), folder.watch);
      folder.watch = -1;
    }
    if (!events_ || folder.watch >= 0 || folder.missing) continue;
    folder.watch = ::inotify_add_watch(events_.number(), folder.path.c_str(), of_interest);
    if (folder.watch >= 0 || errno == ENOENT || errno == ENOTDIR || errno == EACCES) continue;
    // The limit of watches, most likely. Half of the folders with events would only confuse.
    trouble_ = std::generic_category().message(errno);
    events_.close();
    for (Folder& each : folders_) each.watch = -1;
  }
}

void FileChanges::drop_watch(Folder& folder) {
  if (folder.watch >= 0) ::inotify_rm_watch(events_.number(), folder.watch);  // fails if the folder is gone: fine
  folder.watch = -1;
  next_poll_ = Clock::now();  // another folder may have its name already
}

void FileChanges::read_events(Clock::time_point now) {
  alignas(inotify_event) std::array<char, 64 * (sizeof(inotify_event) + NAME_MAX + 1)> buffer{};
  for (;;) {
    const ssize_t got = ::read(events_.number(), buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return;
    const char* const end = buffer.data() + got;
    for (const char* next = buffer.data(); next < end;) {
      const auto* event = reinterpret_cast<const inotify_event*>(next);
      next += sizeof(inotify_event) + event->len;
      take_event(event->wd, event->mask, event->len > 0 ? event->name : "", now);
    }
  }
}

void FileChanges::take_event(int watch, std::uint32_t what, const std::string& name, Clock::time_point now) {
  if (what & IN_Q_OVERFLOW) next_poll_ = now;
  const auto same = [&](const Folder& each) { return each.watch == watch; };
  const auto folder = std::find_if(folders_.begin(), folders_.end(), same);
  if (watch < 0 || folder == folders_.end()) return;
  if (what & (IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED | IN_UNMOUNT)) drop_watch(*folder);
  // Only names on the list count: not "x.cpp~", ".x.cpp.swp", "4913" and what else editors leave behind.
  for (File& file : files_) {
    if (&folders_[file.folder] != &*folder || file.path.filename() != name) continue;
    const bool gone = (what & (IN_DELETE | IN_MOVED_FROM)) != 0;
    const bool begun = (what & IN_CREATE) != 0;  // closing it comes as another event
    suspect(file, now, gone || begun ? for_emptiness : after_closing);
  }
}

void FileChanges::look_at_all(Clock::time_point now) {
  add_watches();
  for (File& file : files_) {
    if (file.due) continue;
    const FileStamp stamp = stamp_of(file.path);
    const bool same = stamp == file.stamp && !file.again;  // or its folder was away when it was to be reported again
    if (same && !file.recent) continue;
    if (same) {
      const std::string now_inside = fingerprint(file.path);
      file.recent = is_recent(stamp);
      if (now_inside == file.fingerprint) continue;
    }
    suspect(file, now, after_a_look);
  }
  next_poll_ = now + (events_ ? between_looks : between_looks_without_events);
}

void FileChanges::suspect(File& file, Clock::time_point now, milliseconds quiet) {
  if (file.due && now - file.suspected >= longest_wait) return;
  if (!file.due) file.suspected = now;
  file.suspected_stamp = stamp_of(file.path);
  file.due = now + quiet;
}

bool FileChanges::still_being_written(File& file, Clock::time_point now) const {
  if (now - file.suspected >= longest_wait) return false;
  const FileStamp stamp = stamp_of(file.path);
  if (stamp != file.suspected_stamp) {
    file.suspected_stamp = stamp;
    file.due = now + (events_ ? after_closing : after_a_look);
    return true;
  }
  if (stamp.size == 0 && now - file.suspected < for_emptiness) {
    file.due = file.suspected + for_emptiness;
    return true;
  }
  return false;
}

void FileChanges::read(File& file) const {
  // The stamp first: what changes while the file is read changes the stamp once more.
  file.stamp = stamp_of(file.path);
  file.recent = is_recent(file.stamp);
  file.fingerprint = fingerprint(file.path);
}

std::vector<std::size_t> FileChanges::collect(Clock::time_point now) {
  if (events_) read_events(now);
  if (now >= next_poll_) look_at_all(now);
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    File& file = files_[i];
    if (!file.due || *file.due > now || still_being_written(file, now)) continue;
    file.due.reset();
    std::error_code ignored;
    if (!fs::is_directory(folders_[file.folder].path, ignored)) continue;  // seen again when the folder is back
    const std::string before = file.fingerprint;
    read(file);
    if (file.fingerprint != before || file.again) changed.push_back(i);
    file.again = false;
  }
  std::stable_sort(changed.begin(), changed.end(),
                   [&](std::size_t a, std::size_t b) { return files_[a].stamp.saved < files_[b].stamp.saved; });
  return changed;
}

Clock::time_point FileChanges::next_look() const {
  Clock::time_point earliest = next_poll_;
  for (const File& file : files_) {
    if (file.due) earliest = std::min(earliest, *file.due);
  }
  return earliest;
}

void FileChanges::report_again(std::size_t index, Clock::time_point now) {
  File& file = files_.at(index);
  file.again = true;
  if (!file.due) suspect(file, now, after_closing);
}

std::vector<fs::path> FileChanges::missing_folders() const {
  std::vector<fs::path> missing;
  for (const Folder& folder : folders_) {
    if (folder.missing) missing.push_back(folder.path);
  }
  return missing;
}

}  // namespace workbook
