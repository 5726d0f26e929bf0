#include "checker/base/files.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/progress.hpp"
#include "checker/course/stub.hpp"

#include <fmt/format.h>

#include <system_error>

namespace workbook {

namespace fs = std::filesystem;

int reset(const Course& course, const std::string& name) {
  const Exercise exercise = course.find_exercise(name);
  const auto stop = [&](const std::string& reason) {
    fmt::print(stderr, "{} was not reset: {}.\n", exercise.name(), reason);
    return checker_failed;
  };
  const std::string signature = declared_signature(course, exercise);
  if (signature.empty())
    return stop(fmt::format("{} does not declare it", shown_path(course.contract_file(*exercise.card))));
  const fs::path file = course.student_file(exercise);
  std::error_code problem;
  if (fs::exists(file, problem)) {
    const fs::path kept = free_name(course.progress_file().parent_path() / "kept" / (exercise.name() + ".cpp"));
    fs::create_directories(kept.parent_path(), problem);
    if (!fs::copy_file(file, kept, problem))
      return stop(fmt::format("your version could not be kept as {} ({})", shown_path(kept), problem.message()));
    fmt::print("Your version is kept as {}.\n", shown_path(kept));
  }
  const std::string failure = write_file(file, stub_text(*exercise.entry, exercise.card->contract, signature));
  if (!failure.empty()) return stop(fmt::format("{} cannot be written ({})", shown_path(file), failure));
  Progress(course.progress_file()).forget(exercise.name());
  fmt::print("{} is as it was at the beginning.\n", shown_path(file));
  return all_passed;
}

}  // namespace workbook
