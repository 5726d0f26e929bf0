#include "checker/base/formulas.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/locked_text.hpp"

#include <algorithm>
#include <cmath>

namespace workbook {

namespace {

struct SolutionOptions {
  std::string name;
  bool now = false;  ///< although the exercise does not pass yet
};

/// What comes out in the limits of the exercise, and why.
std::string limits_text(const Course& course, const Exercise& exercise) {
  const ExerciseReference reference =
      course.reference(exercise.lecture(), course.seed(), exercise.name()).exercises.front();
  std::string text = reference.limits.empty() ? "" : "\nLimits:\n";
  for (const Limit& limit : reference.limits) {
    const Case& one = reference.cases[limit.case_index];
    Value value = one.expected;  // without what rounding leaves of zeros
    for (std::size_t n = 0; n < value.numbers.size(); ++n)
      if (std::abs(value.numbers[n]) <= one.tolerance * scale_at(one, n)) value.numbers[n] = 0;
    const std::string line = fmt::format("- {}: {} = {}. {}", one.name, reference.result_name,
                                         format_value(value, reference.result_kind, 4), limit.reason);
    text += Console::of_standard_output().wrapped(line, 2) + "\n";
  }
  return text;
}

/// Code, then another route or the derivation, which a heading begins, as a terminal shows them.
int show_solution(const Course& course, const Exercise& exercise, const std::string& text) {
  const Console console = Console::of_standard_output();
  const std::size_t heading = std::min(text.find("\n# "), text.size());
  fmt::print("{}\n", text.substr(0, heading));
  for (const std::string& line : lines_of(with_readable_formulas(text.substr(heading))))
    fmt::print("{}\n", line.starts_with("    ") ? line
                       : line.starts_with("# ") ? console.styled(line.substr(2), Style::strong)
                                                : console.wrapped(line));
  const fs::path page = course.notes_folder() / ("exercise_" + exercise.name() + ".html");
  if (fs::exists(page)) fmt::print("Page: {}\n", console.linked(page.filename().string(), file_address(page)));
  fmt::print("{}", limits_text(course, exercise));
  return all_passed;
}

/// What the copy for students keeps locked, opened by the student's own function.
int unlock(const Course& course, const Exercise& exercise, const std::string& locked) {
  CheckContext context(course);
  CheckTask task = check_task(course, exercise);
  task.further = calls_of_locked(locked);
  const CheckResult checked = check_exercise(context, task);
  if (checked.judgement.passed())
    if (const std::optional<std::string> text = unlocked_text(locked, checked.observation.further))
      return show_solution(course, exercise, *text);
  return stop("Your {} does not pass yet; its solution and derivation open once it does.", exercise.name());
}

int solution(const Course& course, const SolutionOptions& options) {
  const Exercise exercise = course.find_exercise(options.name);
  const std::optional<std::string> locked = read_file(course.locked_file(exercise));
  if (locked) return unlock(course, exercise, *locked);
  const std::optional<std::string> code = read_file(course.solution_file(exercise));
  if (!code) return stop("This copy of the workbook does not have this solution; your instructor has it.");
  const Progress progress(course.progress_file());
  if (!options.now && !progress.passed(exercise.name(), file_fingerprint(course.student_file(exercise))))
    return stop("Your {} does not pass yet; its solution is shown once it does, or now by `{}`.", exercise.name(),
                command("solution " + exercise.name() + " --now"));
  return show_solution(course, exercise, *code + "\n" + read_file(course.derivation_file(exercise)).value_or(""));
}

}  // namespace

Command solution_command() {
  const auto options = std::make_shared<SolutionOptions>();
  return {"solution",
          students,
          "Show the solution of an exercise that passes\n\nAnd where another route, or the derivation, is to be read.",
          {"solution inertia_of_points"},
          {exercise_parameter(options->name), {"--now", "", &options->now, "even though yours does not pass yet"}},
          with_options(options, &solution),
          no_help_in_exam(options->name)};
}

}  // namespace workbook
