#include "checker/base/console.hpp"
#include "checker/base/text.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/hints.hpp"
#include "checker/course/progress.hpp"
#include "checker/report/terminal_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace workbook {

int hint(const Course& course, const Options& options) {
  const Console console = Console::of_standard_output();
  Progress progress(course.progress_file());
  const ProgressSummary summary = summary_of(course, progress);
  if (options.name.empty() && summary.next() == nullptr) {
    fmt::print("{}\n", console.wrapped(
                           fmt::format("Every exercise passes, so there is no next one. `{}` shows the hints of one.",
                                       command("hint EXERCISE"))));
    return all_passed;
  }
  const Exercise exercise = options.name.empty() ? *summary.next() : course.find_exercise(options.name);
  const std::vector<std::string> hints = read_hints(course.hints_file(exercise));
  const std::size_t shown_before = progress.hints_shown(exercise.name());
  const std::size_t first = options.all ? 0 : std::min(shown_before, hints.size() - 1);
  const std::size_t last = options.all ? hints.size() - 1 : first;
  for (std::size_t i = first; i <= last; ++i) {
    const std::string heading = fmt::format("Hint {} of {} for {}", i + 1, hints.size(), exercise.name());
    fmt::print("{}\n{}\n\n", console.styled(heading, Style::strong), console.wrapped(hints[i], 2));
  }
  if (last + 1 < hints.size()) {
    fmt::print("For the next hint, type the same again.\n");
  } else {
    fmt::print("That was the last hint. Read on in\n  {}\n", notes_place(course, exercise, exercise.entry->notes));
  }
  progress.remember_hints(exercise.name(), std::max(shown_before, last + 1));
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());
  return all_passed;
}

}  // namespace workbook
