#include "checker/commands/check_exercise.hpp"
#include "checker/commands/commands.hpp"
#include "checker/report/overlay.hpp"

#include <fmt/format.h>

namespace workbook {

int plot(const Course& course, const PlotOptions& options) {
  std::vector<Exercise> exercises;
  if (options.all) exercises = course.exercises();
  for (const std::string& name : options.names) {
    for (const Exercise& exercise : course.find(name)) exercises.push_back(exercise);
  }
  if (exercises.empty()) {
    fmt::print(stderr, "Say which exercise to plot, for example `checker plot {}`, or --all.\n",
               course.exercises().front().name());
    return wrong_usage;
  }
  if (options.file && exercises.size() != 1) {
    fmt::print(stderr, "--file needs the one exercise that the file is for: checker plot EXERCISE --file FILE.\n");
    return wrong_usage;
  }
  const Toolchain toolchain = read_toolchain(course.toolchain_file());
  const std::filesystem::path directory = options.out.value_or(course.scratch() / "plots");
  int worst = all_passed;
  for (const Exercise& exercise : exercises) {
    const LectureReference lecture = course.reference(exercise.lecture(), options.seed);
    const ExerciseReference& reference = lecture.exercise(exercise.name());
    const Checked checked =
        check_exercise(course, toolchain, exercise, reference, options.file.value_or(course.student_file(exercise)));
    if (checked.judgement.verdict == Verdict::checker_error) {
      fmt::print(stderr, "{}\n", checked.judgement.message);
      return checker_failed;
    }
    const Overlay overlay = overlay_of(checked);
    try {
      for (const auto& file : draw_overlay(overlay, directory, exercise.name())) fmt::print("{}\n", file.string());
    } catch (const PlotError& problem) {
      fmt::print(stderr, "{}\n", problem.what());
      return checker_failed;
    }
    if (overlay.student.empty()) {
      fmt::print("{}: only the reference is drawn, because your function gave no value. {}\n", exercise.name(),
                 checked.judgement.message);
      worst = something_failed;
    }
  }
  return worst;
}

}  // namespace workbook
