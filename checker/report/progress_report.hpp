/// @file
/// How far a student has come, on the terminal.
#pragma once

#include "checker/base/console.hpp"
#include "checker/course/course.hpp"
#include "checker/course/progress.hpp"

#include <string>

namespace workbook {

/// What is known of one exercise.
struct State {
  std::string mark;
  std::string words;
  Style style = Style::plain;
};
State state_of(const Course& course, const Progress& progress, const Exercise& exercise);

/// How much of each lecture passes, line by line, and in all.
std::string overview(const Course& course, const ProgressSummary& summary, const Console& console);

/// Every exercise with its state and points, below its lecture.
std::string exercise_list(const Course& course, const Progress& progress, const Console& console);

/// What an exercise asks for, its file and where to read: "Next: NAME" and a few lines below it.
std::string introduction(const Course& course, const Exercise& exercise, const Console& console);

}  // namespace workbook
