#include "checker/commands/commands.hpp"
#include "checker/course/progress.hpp"
#include "checker/course/progress_summary.hpp"
#include "checker/messages/program.hpp"
#include "checker/messages/standing.hpp"
#include "checker/report/console.hpp"

#include <fmt/format.h>

namespace workbook {

namespace {

void print_warning(const Progress& progress) {
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());
}

void print_command(const std::string& label, const std::string& arguments) {
  fmt::print("  {} {}\n", padded(label, 6), messages::command(arguments));
}

}  // namespace

int list(const Course& course) {
  const Progress progress(course.progress_file());
  fmt::print("{}", exercise_list(course, progress, Console::of_standard_output()));
  if (const Standing standing = standing_of(course, progress); const Exercise* next = standing.next())
    fmt::print("\n{}: {}\n", messages::next_exercise(), next->name());
  print_warning(progress);
  return all_passed;
}

int status(const Course& course) {
  const Console console = Console::of_standard_output();
  const Progress progress(course.progress_file());
  const Standing standing = standing_of(course, progress);
  fmt::print("{}\n", overview(course, standing, console));
  if (const Exercise* next = standing.next()) {
    const State state = state_of(course, progress, *next);
    fmt::print("{}", introduction(course, *next, messages::next_exercise(), console));
    if (!progress.verdict(next->name()).empty())
      fmt::print("  {} {}\n", padded(messages::state_row(), 6), console.styled(state.words, state.style));
    print_command(messages::check_row(), "check " + next->name());
    print_command(messages::hint_row(), "hint " + next->name());
    print_command(messages::watch_row(), "watch");
  } else {
    fmt::print("{}\n", console.wrapped(messages::everything_passes(standing.total())));
  }
  print_warning(progress);
  return all_passed;
}

}  // namespace workbook
