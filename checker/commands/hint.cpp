#include "checker/commands/commands.hpp"

#include <algorithm>

namespace workbook {

namespace {

struct HintOptions {
  std::string name;
  bool all = false;
};

/// What was checked last, or else the next exercise, if that does not pass.
Exercise at_hand(const ProgressSummary& summary, const Progress& progress) {
  const auto last = std::ranges::find(summary.exercises, progress.last()[0], &Exercise::name);
  return last != summary.exercises.end() && !summary.passes(*last) ? *last : *summary.next();
}

int hint(const Course& course, const HintOptions& options) {
  const Console console = Console::of_standard_output();
  Progress progress(course.progress_file());
  const ProgressSummary summary = summary_of(course, progress);
  if (options.name.empty() && summary.next() == nullptr) {
    say("Every exercise passes, so there is no next one. `{}` shows the hints of one.", command("hint EXERCISE"));
    return all_passed;
  }
  const Exercise exercise = options.name.empty() ? at_hand(summary, progress) : course.find_exercise(options.name);
  no_help_in_exam(exercise.name())(course);
  const std::vector<std::string> hints = read_hints(course.hints_file(exercise));
  const std::size_t shown_before = progress.of(exercise.name()).hints_shown;
  const std::size_t first = options.all ? 0 : std::min(shown_before, hints.size() - 1);
  const std::size_t last = options.all ? hints.size() - 1 : first;
  for (std::size_t i = first; i <= last; ++i) {
    const std::string heading = fmt::format("Hint {} of {} for {}", i + 1, hints.size(), exercise.name());
    fmt::print("{}\n{}\n\n", console.styled(heading, Style::strong), console.wrapped(hints[i], 2));
  }
  if (last + 1 < hints.size()) {
    fmt::print("For the next hint, type the same again.\n");
  } else {
    fmt::print("That was the last hint. Read on in\n  {}\n",
               notes_place(course, exercise, exercise.entry->notes, console, 2));
  }
  progress.remember_hints(exercise.name(), std::max(shown_before, last + 1));
  warn(progress);
  return all_passed;
}

}  // namespace

Command hint_command() {
  const auto options = std::make_shared<HintOptions>();
  return {
      "hint",
      students,
      "Show the next hint of an exercise\n\nEvery exercise has three hints, weakest first. Each call shows one more; "
      "the last one stays. Without a name: the exercise that was checked last, or else the next one that does not "
      "pass.",
      {"hint", "hint inertia_of_points", "hint inertia_of_points --all"},
      {exercise_parameter(options->name,
                          "its name; none: the one that was checked last, or else the next one, if that does not "
                          "pass",
                          false),
       {"--all", "", &options->all, "show all three"}},
      with_options(options, &hint)};
}

}  // namespace workbook
