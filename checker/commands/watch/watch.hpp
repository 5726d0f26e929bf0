/// @file
/// What the watch looks at and shows: files that change, the terminal, and what is on its screen.
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/base/console.hpp"
#include "checker/base/text.hpp"

#include <sys/stat.h>

#include <array>
#include <cstdint>

namespace workbook {

namespace fs = std::filesystem;

// --- which of some files have new content. Two ways to notice, side by side: the system's events, which are quick, and
// a look at every file now and then, which also works in folders that send no events (a network, a container)

/// Reports a file when its content has changed and whoever wrote it seems to have finished: an editor that writes in
/// place, in pieces, or under another name first. The same content saved again is no change. An event only makes the
/// next look come at once, so nothing depends on what it says or on whether one is lost.
class FileChanges {
 public:
  /// The files as they are now count as known. None of them needs to exist.
  explicit FileChanges(const std::vector<fs::path>& files, bool with_events = true);

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
  const std::vector<fs::path>& missing_folders() const { return missing_; }

 private:
  /// Two states of a file that differ have different stamps, unless they follow each other within the clock's tick.
  using Stamp = std::array<std::int64_t, 6>;
  struct File {
    fs::path path;
    std::string fingerprint;                 ///< of what was read; "" if there was no file
    Stamp stamp{};                           ///< when it was read
    bool is_recent = false;                  ///< changed so shortly before that the stamp cannot show one more change
    Stamp seen{};                            ///< at the last look
    std::optional<Clock::time_point> since;  ///< when it was first seen to be different
  };

  static Stamp stamp_of(const fs::path& file);
  static bool read(File& file, const Stamp& stamp);
  void find_folders();
  bool drain_events() const;

  std::vector<File> files_;
  std::vector<fs::path> folders_;
  std::vector<fs::path> missing_;
  Descriptor events_;
  std::string events_missing_;
  Clock::time_point next_look_ = Clock::now();
};

// --- the terminal: its size, its keys one by one, its cursor, and its signals

struct TerminalSize {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

/// The keys at the front of what was typed, which are taken from it: small letters, and a whole escape sequence as one
/// key, so that no part of it is taken for a letter. What is cut in the middle stays for the next call.
std::vector<std::string> take_keys(std::string& typed);

/// While this lives, every key arrives at once and none is shown. The terminal is as before at the end of it, and also
/// when a signal such as SIGSEGV ends the program. From its making to the end of the program, the signals that end,
/// stop, continue or resize a program on a terminal are read, not delivered.
class Terminal {
 public:
  /// @throws std::system_error
  Terminal();
  ~Terminal();

  bool has_keyboard() const { return has_keyboard_; }

  /// Standard output is a terminal that understands more than letters.
  static bool can_be_drawn_on();
  /// Of standard output; 80 by 24 where it does not say.
  static TerminalSize size();

  /// Writes all of it to standard output at once. False if nobody reads it any more.
  static bool write(std::string_view text);

  /// What was typed, as it comes; "" at the end of the terminal.
  static std::string read();

  /// Becomes readable when a signal has come.
  int signals() const { return signals_.number(); }
  std::vector<int> take_signals();

  /// Does what Ctrl-Z usually does; returns when the program is continued.
  void stop();
  /// Every key at once, again: a shell that continues a program may have changed that.
  void take_keyboard() const;

 private:
  void give_keyboard_back() const;

  bool has_keyboard_;
  Descriptor signals_;
};

// --- the screen, laid out for a terminal of a given size. Pure text: nothing here writes to a terminal

/// What is to be seen. Body and state may hold colours and lines that are too long.
struct Scene {
  std::string lecture;  ///< of the current exercise
  std::string exercise;
  std::size_t passed = 0;  ///< of all exercises, for the bar
  std::size_t total = 0;
  std::string body;           ///< verdicts, hints: as long as they like
  std::string state;          ///< one line: what goes on; "" if nothing does
  std::string idle;           ///< in its place then, if the whole body is to be seen
  std::string keys;           ///< what can be pressed
  std::size_t first_row = 0;  ///< of the body, for scrolling
};

/// The rows of the terminal, from its top to its last.
struct Layout {
  std::vector<std::string> rows;
  std::size_t end_of_body = 0;  ///< how many rows are heading and body
  std::size_t body_shown = 0;   ///< rows of the body that fit
  std::size_t first_row = 0;    ///< of the body, corrected if it was too far
};

/// Never more rows than the terminal has, none wider than it is. What does not fit is announced in the state's line.
Layout lay_out(const Scene& scene, TerminalSize size, const Console& console);

/// The text as rows of at most `width` columns. A colour or a link that is on at the end of a row goes on in the next;
/// other control characters become "?".
std::vector<std::string> folded(const std::string& text, std::size_t width);

}  // namespace workbook
