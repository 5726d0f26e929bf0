#include "checker/base/console.hpp"
#include "checker/base/text.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/inspection.hpp"
#include "checker/course/progress.hpp"
#include "checker/report/progress_report.hpp"

#include <fmt/format.h>

namespace workbook {

namespace {

void print_remarks(const Course& course, const Progress& progress) {
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());
  for (const Card& card : course.cards())
    for (const std::string& remark : stray_exercises(course, card)) fmt::print(stderr, "{}\n", remark);
}

}  // namespace

int list(const Course& course) {
  const Progress progress(course.progress_file());
  fmt::print("{}", exercise_list(course, progress, Console::of_standard_output()));
  if (const ProgressSummary summary = summary_of(course, progress); const Exercise* next = summary.next())
    fmt::print("\nNext: {}\n", next->name());
  print_remarks(course, progress);
  return all_passed;
}

int status(const Course& course) {
  const Console console = Console::of_standard_output();
  const Progress progress(course.progress_file());
  const ProgressSummary summary = summary_of(course, progress);
  fmt::print("{}\n", overview(course, summary, console));
  if (const Exercise* next = summary.next()) {
    const State state = state_of(course, progress, *next);
    fmt::print("{}", introduction(course, *next, console));
    if (!progress.verdict(next->name()).empty()) fmt::print("  state  {}\n", console.styled(state.words, state.style));
    fmt::print("  check  {}\n  hint   {}\n  watch  {}\n", command("check " + next->name()),
               command("hint " + next->name()), command("watch"));
  } else {
    fmt::print("{}\n",
               console.wrapped(fmt::format("All {} exercises pass. You have written the library; `{}` runs the "
                                           "worked examples of a lecture on it, `{}` draws its figures.",
                                           summary.exercises.size(), command("examples 03"), command("figures 03"))));
  }
  print_remarks(course, progress);
  return all_passed;
}

}  // namespace workbook
