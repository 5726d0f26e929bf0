/// @file
/// Which of some files have new content. Two ways to notice, side by side: the system's events, which are quick, and a
/// look at every file now and then, which also works in folders that send no events (a network, a container).
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/base/descriptor.hpp"

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace workbook {

/// What tells two states of a file apart without reading it.
struct FileStamp {
  bool exists = false;
  ino_t inode = 0;
  off_t size = 0;
  std::chrono::nanoseconds modified{};
  std::chrono::nanoseconds saved{};  ///< when it came to be there as it is; `modified` may be copied from another file

  /// The same state, whatever its name and its permissions went through.
  bool operator==(const FileStamp& other) const {
    return exists == other.exists && inode == other.inode && size == other.size && modified == other.modified;
  }
};

/// Of a file that cannot be reached: `exists` is false.
FileStamp stamp_of(const std::filesystem::path& file);

/// Reports a file when its content has changed and whoever wrote it seems to have finished: an editor that writes in
/// place, in pieces, or under another name first. The same content saved again is no change.
class FileChanges {
 public:
  enum class Events { wanted, unwanted };

  /// The files as they are now count as known. None of them needs to exist.
  explicit FileChanges(std::vector<std::filesystem::path> files, Events events = Events::wanted);

  /// Becomes readable when something happened; −1 where the system gives no events.
  int descriptor() const { return events_.number(); }

  /// Why there are no events although they were wanted: the system's reason, else "".
  const std::string& trouble() const { return trouble_; }

  /// The files that have changed since they were last reported, by their place in the list; what was saved last comes
  /// last.
  std::vector<std::size_t> collect(Clock::time_point now = Clock::now());

  /// When collect() is to be called at the latest.
  Clock::time_point next_look() const;

  /// Counts content that was seen elsewhere as reported: the next change is one from there.
  void know(std::size_t index, const std::string& fingerprint) { files_.at(index).fingerprint = fingerprint; }

  /// Reports the file soon, whether its content changes or not.
  void report_again(std::size_t index, Clock::time_point now = Clock::now());

  /// The folders of the files that are not there now. Their files are not reported as changed.
  std::vector<std::filesystem::path> missing_folders() const;

 private:
  struct File {
    std::filesystem::path path;
    std::size_t folder = 0;
    FileStamp stamp;          ///< when it was last read
    std::string fingerprint;  ///< of what was read
    bool recent = false;      ///< changed so shortly before it was read that its time cannot show one more change
    bool again = false;       ///< to be reported in any case
    std::optional<Clock::time_point> due;  ///< when to read it
    Clock::time_point suspected;           ///< since when
    FileStamp suspected_stamp;             ///< as it was then
  };
  struct Folder {
    std::filesystem::path path;
    int watch = -1;
    bool missing = false;
  };

  void add_watches();
  void drop_watch(Folder& folder);
  void read_events(Clock::time_point now);
  void take_event(int watch, std::uint32_t what, const std::string& name, Clock::time_point now);
  void look_at_all(Clock::time_point now);
  void suspect(File& file, Clock::time_point now, std::chrono::milliseconds quiet);
  bool still_being_written(File& file, Clock::time_point now) const;
  void read(File& file) const;

  std::vector<File> files_;
  std::vector<Folder> folders_;
  Descriptor events_;
  std::string trouble_;
  Clock::time_point next_poll_;
};

}  // namespace workbook
