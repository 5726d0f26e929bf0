/// @file
/// How far a student has come, and the exercise that is next.
#pragma once

#include "checker/course/course.hpp"
#include "checker/course/progress.hpp"
#include "checker/report/console.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace workbook {

/// Every exercise of the course, in course order, and whether it passes as its file stands now.
struct Standing {
  std::vector<Exercise> exercises;
  std::vector<bool> passed;

  std::size_t total() const { return exercises.size(); }
  std::size_t count_passed() const;
  std::size_t count_passed(const std::string& lecture) const;

  /// The first exercise that does not pass, or nullptr if all do.
  const Exercise* next() const;
};

Standing standing_of(const Course& course, const Progress& progress);

/// What is known of one exercise.
struct State {
  std::string mark;
  std::string words;
  Style style = Style::plain;
};

State state_of(const Course& course, const Progress& progress, const Exercise& exercise);

/// How much of each lecture passes, line by line, and in all.
std::string overview(const Course& course, const Standing& standing, const Console& console);

/// Every exercise with its state and points, below its lecture.
std::string exercise_list(const Course& course, const Progress& progress, const Console& console);

/// What an exercise asks for, its file and where to read: "Next: NAME" and a few lines below it.
/// @param label  what stands before the name
std::string introduction(const Course& course, const Exercise& exercise, const std::string& label,
                         const Console& console);

}  // namespace workbook
