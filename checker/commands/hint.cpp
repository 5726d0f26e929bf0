#include "checker/commands/commands.hpp"
#include "checker/course/hints.hpp"
#include "checker/course/progress.hpp"
#include "checker/messages/hinting.hpp"
#include "checker/report/console.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace workbook {

int hint(const Course& course, const std::string& name, bool all) {
  const Exercise exercise = course.find_exercise(name);
  const std::vector<std::string> hints = read_hints(course.hints_file(exercise));
  const Console console = Console::of_standard_output();
  Progress progress(course.progress_file());

  const std::size_t shown_before = progress.hints_shown(name);
  const std::size_t first = all ? 0 : std::min(shown_before, hints.size() - 1);
  const std::size_t last = all ? hints.size() - 1 : first;
  for (std::size_t i = first; i <= last; ++i) {
    fmt::print("{}\n{}\n\n", console.styled(messages::hint_heading(i + 1, hints.size()), Style::strong),
               console.wrapped(hints[i], 2));
  }
  if (last + 1 < hints.size()) {
    fmt::print("{}\n", messages::hint_goes_on());
  } else {
    const std::string notes = course.notes_file(*exercise.card).lexically_relative(course.root()).string();
    fmt::print("{}\n", messages::hint_was_the_last(notes, exercise.entry->notes));
  }
  progress.remember_hints(name, std::max(shown_before, last + 1));
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());
  return all_passed;
}

}  // namespace workbook
