/// @file
/// Programs of the workbook itself, as the checker starts them: the build, and what it has built.
#pragma once

#include "checker/course/course.hpp"
#include "checker/worker/child_process.hpp"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace workbook {

/// Builds a target of the build that this program belongs to, with a progress bar. @throws LaunchError
FinishedProgram build_target(const Course& course, const std::string& target);

/// Runs a program outside the sandbox, with PATH as its only environment. @throws LaunchError
FinishedProgram run_own_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                                std::chrono::seconds time_limit);

}  // namespace workbook
