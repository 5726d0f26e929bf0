/// @file
/// The watch: whatever exercise is saved is checked, and the verdict is shown in place.
#pragma once

#include "checker/course/course.hpp"
#include "checker/report/console.hpp"
#include "checker/watch/checker_process.hpp"
#include "checker/watch/file_changes.hpp"
#include "checker/watch/keys.hpp"
#include "checker/watch/screen.hpp"
#include "checker/watch/signals.hpp"
#include "checker/watch/terminal.hpp"

#include <chrono>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace workbook {

/// Where a watch begins and how far it leads on by itself. Saved files are checked whatever exercise they are.
struct WatchedPart {
  std::vector<Exercise> exercises;  ///< one exercise, a lecture or the course
  std::string name;                 ///< of the lecture; "" for the course and for one exercise
};

/// One loop waits for saved files, keys, signals and the output of the running check. Every check is a process of its
/// own: keys work meanwhile, and a save of the file that is being checked ends that check and begins another.
class Watch {
 public:
  /// @pre the part has an exercise
  Watch(const Course& course, std::filesystem::path course_file, const WatchedPart& part);

  /// Until a key, a signal or the end of the terminal ends it.
  void run();

 private:
  enum class Reason {
    saved,    ///< a verdict is owed, come what may
    arrived,  ///< to see how the exercise stands that the watch has come to
    asked     ///< by a key, or by name: the exercise stays even if it passes
  };
  struct Wanted {
    std::size_t index = 0;
    Reason reason = Reason::saved;
    std::string content;  ///< fingerprint of what was saved
  };
  struct Check {
    Wanted wanted;
    FileStamp stamp;  ///< of the file when the check began
    std::string fingerprint;
    std::unique_ptr<CheckerProcess> process;
    bool said = false;  ///< that it takes a while
  };
  struct Request {
    Action action = Action::unknown;
    std::size_t index = 0;
    std::unique_ptr<CheckerProcess> process;
  };

  // What comes in.
  void wait();
  void on_signals();
  void on_keys();
  void on_key(const Key& key);
  void on_changes();
  void on_saved(std::size_t index);
  void show(std::size_t index);

  // Checks and other commands.
  void begin_next_check();
  void finish_check();
  void begin_request(Action action);
  void finish_request();

  // From exercise to exercise.
  void go_to(std::size_t index, Reason reason);
  void check_again();
  void forget_what_is_not_owed();
  void go_on_after_passing();
  void go_on_by_key();
  std::optional<std::size_t> next_after(std::size_t index, const std::vector<std::size_t>& among) const;
  void read_progress();
  std::size_t count_passed() const;

  // What is shown: on a screen in place, otherwise one below the other.
  void notice(const std::string& text);
  void verdict(const std::string& text);
  void panel(const std::string& text);
  void print(const std::string& text);
  void scroll(long rows);
  std::string words_of_check() const;
  std::string words_of_keys() const;
  std::string body_above_panel() const;
  Scene scene() const;
  void draw();
  void begin_screen();
  void leave_screen();

  const std::filesystem::path& file(std::size_t index) const { return files_[index]; }
  const std::string& name(std::size_t index) const { return exercises_[index].name(); }

  const Course& course_;
  std::filesystem::path course_file_;
  std::vector<Exercise> exercises_;
  std::vector<std::filesystem::path> files_;
  std::vector<std::size_t> everything_;
  std::vector<std::size_t> part_;
  std::string part_name_;
  std::vector<bool> passed_;
  std::vector<std::string> passed_here_;    ///< fingerprints, in case the progress cannot be saved
  std::vector<std::string> judged_;         ///< fingerprint of what the last verdict was on
  std::vector<std::string> doubtful_;       ///< fingerprint of what is to be checked again, and was not saved anew
  std::size_t current_ = 0;                 ///< what the screen is for
  std::chrono::nanoseconds shown_since_{};  ///< when the save was that brought it there

  Signals signals_;
  Console console_;
  bool on_screen_;
  KeyByKey keyboard_;
  KeyReader key_reader_;
  FileChanges changes_;

  std::deque<Wanted> waiting_;
  std::optional<Check> check_;
  std::optional<Request> request_;

  std::vector<std::string> notices_;
  std::vector<std::filesystem::path> missing_folders_;
  std::string verdict_;
  std::string panel_;
  std::string remark_;  ///< about the last key
  std::string trouble_;
  std::size_t first_row_ = 0;
  Layout layout_;
  bool changed_ = true;  ///< the screen is to be drawn
  bool over_ = false;
};

}  // namespace workbook
