/// @file
/// Programs of the workbook that are built when somebody asks for them: worked examples and figures.
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/course/course.hpp"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace workbook {

/// Runs a program that finds others on PATH and inherits nothing else. @throws LaunchError
FinishedProgram run_with_path(const std::string& program, const std::vector<std::string>& arguments,
                              std::chrono::duration<double> limit);

/// Builds one target of the workbook's own build. @throws LaunchError
FinishedProgram build_target(const Course& course, const std::string& target);

/// The student's files that the compiler complains about in the output of a build.
std::vector<std::string> files_with_errors(const std::string& output);

/// Where the build puts the programs of the lectures.
std::filesystem::path lecture_program(const Course& course, const std::string& target);

}  // namespace workbook
