/// @file
/// Programs of the workbook that are built when they are asked for: worked examples and figures.
#pragma once

#include "checker/base/build.hpp"
#include "checker/base/console.hpp"
#include "checker/course/course.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace workbook {

/// Builds one target of the workbook's own build. @throws LaunchError
FinishedProgram build_target(const Course& course, const std::string& target);

/// Builds a lecture's program on the student's functions and returns its path. Where files of the student do not
/// compile, names them and returns "". @throws std::runtime_error if it cannot be built for another reason
std::string student_program(const Course& course, const std::string& target, const std::string& what);

/// Copies the pictures of a lecture into a folder; returns how many figures they show.
/// @throws std::filesystem::filesystem_error
std::size_t copy_figures(const Course& course, const std::string& lecture, const std::filesystem::path& to);

/// What became of a worked example or a figure.
struct Outcome {
  std::string trouble;  ///< empty: none
  bool is_not_started = false;

  bool is_good() const { return trouble.empty(); }
};
void print_outcome(const Console& console, const std::string& name, const Outcome& outcome);

}  // namespace workbook
