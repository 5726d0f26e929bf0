/// @file
/// Exercise after exercise through the checker, as one command line asks for it.
#pragma once

#include "checker/pipeline/check_exercise.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace workbook {

/// Checks exercises with one seed, each on its own file or all on the one that was named. What it returns refers to the
/// reference results that are kept here, read once per lecture.
class Checking {
 public:
  /// @throws ToolchainError
  Checking(const Course& course, std::uint64_t seed, std::optional<std::filesystem::path> file);

  /// The file that is checked for an exercise.
  std::filesystem::path file_of(const Exercise& exercise) const;

  /// @throws ReferenceError
  Checked operator()(const Exercise& exercise);

 private:
  const Course& course_;
  std::uint64_t seed_;
  std::optional<std::filesystem::path> file_;
  Toolchain toolchain_;
  std::map<std::string, LectureReference> references_;
};

}  // namespace workbook
