/// @file
/// An exam that a student sets himself: problems that were not seen before, a time, and no help until it is graded.
#pragma once

#include "checker/course/course.hpp"

#include <chrono>

namespace workbook {

/// The exam that is running, as .workbook/exam.json keeps it.
struct Exam {
  std::int64_t started = 0;  ///< seconds since 1970
  int minutes = 0;           ///< that it may take
  std::uint64_t seed = 0;    ///< that drew its problems
  std::vector<std::string> problems;

  /// Negative when the time is over.
  std::chrono::seconds time_left() const;
};

fs::path exam_file(const Course& course);

/// @throws UsageError where its file is damaged, with what to do
std::optional<Exam> running_exam(const Course& course);

/// Problems of "01-03" or "5" that have no verdict, no hint and an untouched file: at most six, drawn by the seed, in
/// the order of the course.
/// @throws UsageError where the lectures are no range of the course, or hold no such problem
std::vector<Exercise> drawn_problems(const Course& course, const Progress& progress, const std::string& lectures,
                                     std::uint64_t seed);

/// @throws std::runtime_error where it cannot be written
void write_exam(const Course& course, const Exam& exam);

/// @throws UsageError in one sentence where one of these is a problem of the running exam
void refuse_in_exam(const Course& course, const std::vector<Exercise>& exercises);

/// "2 h 5 min", "1 h" or "40 min": rounded to minutes, without a sign.
std::string hours_and_minutes(std::chrono::seconds time);

/// "12 min left"
std::string time_text(const Exam& exam);

}  // namespace workbook
