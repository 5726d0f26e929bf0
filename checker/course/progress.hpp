/// @file
/// What the student has done so far. Survives restarts; a damaged file is set aside, never fatal.
#pragma once

#include "checker/course/course.hpp"

namespace workbook {

/// Today's date, "2026-11-22"; WORKBOOK_TODAY sets another one.
std::string current_day();

/// The first verdict on an exercise that was written once more.
struct Review {
  std::string day;
  std::string verdict;
};

/// What became of an exercise after it was solved.
struct Practice {
  std::string passed_on;  ///< the day when it first passed; "" if it has not
  std::vector<Review> reviews;
  std::optional<bool> answered_right;  ///< the first answer to its question
};

class Progress {
 public:
  /// Reads the file; a missing one is an empty progress. A damaged one is renamed to FILE.damaged and warning() says
  /// so.
  explicit Progress(fs::path file) : file_(std::move(file)) { read(); }

  /// Remembers a verdict ("passed", "wrong_value") on a text and writes the file, under another name first, so that it
  /// is never half written. What another checker has written meanwhile is kept. If it cannot be written, warning() says
  /// so and the check goes on.
  /// @param values  fingerprint of what a failing function returned
  /// @return true if another text has just returned the same wrong values
  bool remember(const std::string& exercise, const std::string& verdict, const std::string& source,
                const std::string& values = "");

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

  Practice practice(const std::string& exercise) const { return of(exercise).practice; }
  /// Only the first answer counts.
  void remember_answer(const std::string& exercise, bool is_right);
  /// Only the first verdict of a review counts: one on the same day is none.
  void remember_review(const std::string& exercise, const Review& review);

  /// One sentence, or "" if all is well.
  const std::string& warning() const { return warning_; }

 private:
  struct Known {
    std::string verdict;
    std::string source;  ///< fingerprint of the file that was judged
    std::size_t hints = 0;
    std::string values;  ///< fingerprint of the wrong values, if it failed with any
    Practice practice;
  };

  Known of(const std::string& exercise) const { return known_.contains(exercise) ? known_.at(exercise) : Known{}; }
  void read();
  template <class Change>
  void change(const Change& something);

  fs::path file_;
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
