/// @file
/// What the student has done so far. Survives restarts; a damaged file is set aside, never fatal.
#pragma once

#include "checker/course/course.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace workbook {

/// The last verdict on one exercise.
struct LastVerdict {
  std::string verdict;  ///< "passed", "wrong_value", …
  std::string source;   ///< fingerprint of the file that was judged
};

class Progress {
 public:
  /// Reads the file; a missing one is an empty progress. A damaged one is renamed to FILE.damaged and warning() says
  /// so.
  explicit Progress(std::filesystem::path file);

  /// Remembers a verdict and writes the file, under another name first, so that it is never half written. What another
  /// checker has written meanwhile is kept. If it cannot be written, warning() says so and the check goes on.
  void remember(const std::string& exercise, const LastVerdict& verdict);

  /// Forgets an exercise.
  void forget(const std::string& exercise);

  /// Nothing ("") if the exercise was never checked.
  std::string verdict(const std::string& exercise) const;

  /// True if the exercise passed and its file has not changed since.
  bool passed(const std::string& exercise, const std::string& source) const;

  /// How many hints of the exercise have been shown.
  std::size_t hints_shown(const std::string& exercise) const;
  void remember_hints(const std::string& exercise, std::size_t count);

  /// One sentence, or "" if all is well.
  const std::string& warning() const { return warning_; }

 private:
  void read();
  void change(const std::function<void()>& something);
  void write();

  std::filesystem::path file_;
  std::map<std::string, LastVerdict> verdicts_;
  std::map<std::string, std::size_t> hints_;
  std::string warning_;
};

/// Which exercises of the course pass as their files stand now, in course order.
struct ProgressSummary {
  std::vector<Exercise> exercises;
  std::vector<bool> passed;

  std::size_t count_passed() const;
  std::size_t count_passed(const std::string& lecture) const;
  /// The first exercise that does not pass, or nullptr if all do.
  const Exercise* next() const;
};
ProgressSummary summary_of(const Course& course, const Progress& progress);

}  // namespace workbook
