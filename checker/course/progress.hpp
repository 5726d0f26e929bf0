/// @file
/// What the student has done so far. Survives restarts; a damaged file is set aside, never fatal.
#pragma once

#include "checker/course/course.hpp"

namespace workbook {

class Progress {
 public:
  /// Reads the file; a missing one is an empty progress. A damaged one is renamed to FILE.damaged and warning() says
  /// so.
  explicit Progress(std::filesystem::path file) : file_(std::move(file)) { read(); }

  /// Remembers a verdict ("passed", "wrong_value") on a text and writes the file, under another name first, so that it
  /// is never half written. What another checker has written meanwhile is kept. If it cannot be written, warning() says
  /// so and the check goes on.
  void remember(const std::string& exercise, const std::string& verdict, const std::string& source);

  /// Forgets an exercise.
  void forget(const std::string& exercise);

  /// Nothing ("") if the exercise was never checked.
  std::string verdict(const std::string& exercise) const { return of(exercise).verdict; }

  /// True if the exercise passed and its file has not changed since. @param source  the file's fingerprint
  bool passed(const std::string& exercise, const std::string& source) const {
    return of(exercise).verdict == "passed" && of(exercise).source == source;
  }

  /// How many hints of the exercise have been shown.
  std::size_t hints_shown(const std::string& exercise) const { return of(exercise).hints; }
  void remember_hints(const std::string& exercise, std::size_t count);

  /// One sentence, or "" if all is well.
  const std::string& warning() const { return warning_; }

 private:
  struct Known {
    std::string verdict;
    std::string source;  ///< fingerprint of the file that was judged
    std::size_t hints = 0;
  };

  Known of(const std::string& exercise) const { return known_.contains(exercise) ? known_.at(exercise) : Known{}; }
  void read();
  template <class Change>
  void change(const Change& something);

  std::filesystem::path file_;
  std::map<std::string, Known> known_;
  std::string warning_;
};

/// Which exercises of the course pass as their files stand now, in course order.
struct ProgressSummary {
  std::vector<Exercise> exercises;
  std::vector<bool> passed;

  /// Those of a lecture; "": of the course.
  std::size_t count_passed(const std::string& lecture = "") const;
  /// The first exercise that does not pass, or nullptr if all do.
  const Exercise* next() const;
};
ProgressSummary summary_of(const Course& course, const Progress& progress);

}  // namespace workbook
