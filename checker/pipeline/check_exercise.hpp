/// @file
/// The way of one exercise through the checker: compile, run, judge.
#pragma once

#include "checker/compile/toolchain.hpp"
#include "checker/course/course.hpp"
#include "checker/data/observation.hpp"
#include "checker/judging/judgement.hpp"
#include "checker/sandbox/run_exercise.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace workbook {

/// One exercise, checked.
struct Checked {
  Exercise exercise;
  std::filesystem::path file;
  bool is_elsewhere = false;  ///< the file is not the exercise's own
  std::uint64_t seed = 1;
  const ExerciseReference* reference = nullptr;
  Observation observation;
  Judgement judgement;
  std::optional<std::filesystem::path> executable;  ///< for the plot; absent if the file did not compile
};

/// Checks one file against reference results. Never throws for anything that a student's file can cause; trouble of our
/// own comes back as the verdict checker_error.
Checked check_exercise(const Course& course, const Toolchain& toolchain, const Exercise& exercise,
                       const ExerciseReference& reference, const std::filesystem::path& file,
                       const RunLimits& limits = {});

}  // namespace workbook
