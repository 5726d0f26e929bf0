#include "checker/pipeline/checking.hpp"

#include <utility>

namespace workbook {

Checking::Checking(const Course& course, std::uint64_t seed, std::optional<std::filesystem::path> file)
    : course_(course), seed_(seed), file_(std::move(file)), toolchain_(read_toolchain(course.toolchain_file())) {}

std::filesystem::path Checking::file_of(const Exercise& exercise) const {
  return file_.value_or(course_.student_file(exercise));
}

Checked Checking::operator()(const Exercise& exercise) {
  const std::string& lecture = exercise.lecture();
  if (!references_.contains(lecture)) references_.emplace(lecture, course_.reference(lecture, seed_));
  const ExerciseReference& reference = references_.at(lecture).exercise(exercise.name());
  Checked checked = check_exercise(course_, toolchain_, exercise, reference, file_of(exercise));
  checked.seed = seed_;
  return checked;
}

}  // namespace workbook
