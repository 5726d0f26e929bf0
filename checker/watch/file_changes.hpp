/// @file
/// Which of some files have new content. Two ways to notice, side by side: the system's events, which are quick, and a
/// look at every file now and then, which also works in folders that send no events (a network, a container).
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/base/files.hpp"

#include <sys/stat.h>

#include <array>
#include <cstdint>

namespace workbook {

/// Reports a file when its content has changed and whoever wrote it seems to have finished: an editor that writes in
/// place, in pieces, or under another name first. The same content saved again is no change. An event only makes the
/// next look come at once, so nothing depends on what it says or on whether one is lost.
class FileChanges {
 public:
  /// The files as they are now count as known. None of them needs to exist.
  explicit FileChanges(const std::vector<std::filesystem::path>& files, bool with_events = true);

  /// Becomes readable when something happened; −1 without events.
  int descriptor() const { return events_.number(); }

  /// Why there are no events; "" if there are.
  const std::string& events_missing() const { return events_missing_; }

  /// The files that have changed since they were last reported, by their place in the list; what was saved last comes
  /// last.
  std::vector<std::size_t> collect();

  /// When collect() is to be called at the latest.
  Clock::time_point next_look() const { return next_look_; }

  /// The folders of the files that are not there now. Their files are not reported as changed.
  const std::vector<std::filesystem::path>& missing_folders() const { return missing_; }

 private:
  /// Two states of a file that differ have different stamps, unless they follow each other within the clock's tick.
  using Stamp = std::array<std::int64_t, 6>;
  struct File {
    std::filesystem::path path;
    std::string fingerprint;                 ///< of what was read; "" if there was no file
    Stamp stamp{};                           ///< when it was read
    bool is_recent = false;                  ///< changed so shortly before that the stamp cannot show one more change
    Stamp seen{};                            ///< at the last look
    std::optional<Clock::time_point> since;  ///< when it was first seen to be different
  };

  static Stamp stamp_of(const std::filesystem::path& file);
  static bool read(File& file, const Stamp& stamp);
  void find_folders();
  bool drain_events() const;

  std::vector<File> files_;
  std::vector<std::filesystem::path> folders_;
  std::vector<std::filesystem::path> missing_;
  Descriptor events_;
  std::string events_missing_;
  Clock::time_point next_look_ = Clock::now();
};

}  // namespace workbook
