#include "checker/commands/commands.hpp"

namespace workbook {

namespace {

int reset(const Course& course, const std::string& name) {
  const Exercise exercise = course.find_exercise(name);
  const auto refuse = [&](const std::string& reason) {
    fmt::print(stderr, "{} was not reset: {}.\n", exercise.name(), reason);
    return checker_failed;
  };
  const std::string signature = declared_signature(course, exercise);
  if (signature.empty()) return refuse(shown_path(course.contract_file(*exercise.card)) + " does not declare it");
  const fs::path file = course.student_file(exercise);
  std::error_code problem;
  if (fs::exists(file, problem)) {
    const auto kept = free_name(course.progress_file().parent_path() / "kept" / (exercise.name() + ".cpp"));
    fs::create_directories(kept.parent_path(), problem);
    if (!fs::copy_file(file, kept, problem))
      return refuse(fmt::format("your version could not be kept as {} ({})", shown_path(kept), problem.message()));
    fmt::print("Your version is kept as {}.\n", shown_path(kept));
  }
  const std::string failure = write_file(file, stub_text(exercise, signature));
  if (!failure.empty()) return refuse(fmt::format("{} cannot be written ({})", shown_path(file), failure));
  Progress(course.progress_file()).forget(exercise.name());
  fmt::print("{} is as it was at the beginning.\n", shown_path(file));
  return all_passed;
}

}  // namespace

Command reset_command() {
  const auto options = std::make_shared<std::string>();
  return {"reset",
          students,
          "Put an exercise back to the beginning\n\nYour version is kept in the folder .workbook/kept.",
          {"reset inertia_of_points"},
          {exercise_parameter(*options)},
          with_options(options, &reset)};
}

}  // namespace workbook
