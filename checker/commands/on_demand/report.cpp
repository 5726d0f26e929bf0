#include "checker/commands/on_demand/options.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace workbook {

namespace {

/// An exercise of a lecture in which nothing is written yet: no reference results are made to say so.
CheckResult untouched(const CheckTask& task) {
  CheckResult checked;
  checked.task = task;
  checked.judgement.verdict = Verdict::not_started;
  return checked;
}

bool is_untouched(const Course& course, const CheckTask& task) {
  if (task.is_elsewhere) return false;
  return !fs::exists(task.file) ||
         read_file(task.file) == stub_text(task.exercise, declared_signature(course, task.exercise));
}

}  // namespace

int report(const Course& course, const ReportOptions& options) {
  const std::vector<CheckTask> tasks = tasks_of(course, options, true);
  std::set<std::string> begun;
  for (const CheckTask& task : tasks)
    if (!is_untouched(course, task)) begun.insert(task.exercise.lecture());
  std::vector<CheckTask> to_check;
  std::ranges::copy_if(tasks, std::back_inserter(to_check),
                       [&](const CheckTask& task) { return begun.contains(task.exercise.lecture()); });

  ReportedCourse reported;
  reported.student = options.student;
  reported.date = current_day();
  reported.seed = options.seed.value_or(course.seed());
  const bool has_gnuplot = !program_on_path("gnuplot").empty();
  if (!has_gnuplot) reported.picture_trouble = gnuplot_is_missing;
  for (const Card& card : course.cards()) reported.headings.merge(read_headings(course.notes_file(card)));

  CheckContext context(course);
  const Progress progress(course.progress_file());
  for (CheckTask& task : to_check) {
    set_stage(task, progress);
    if (has_gnuplot) task.draw = [&](CheckResult& checked) { add_picture(checked, course.plots()); };
  }
  const auto add_untouched_before = [&](const std::string& name) {
    for (std::size_t k = reported.exercises.size(); k < tasks.size() && tasks[k].exercise.name() != name; ++k)
      reported.exercises.push_back({untouched(tasks[k])});
  };
  ProgressBar progress_bar;
  check_all(context, to_check, [&](CheckResult checked) {
    add_untouched_before(checked.name());
    progress_bar.show(reported.exercises.size(), tasks.size(), checked.name());
    const auto answered = progress.of(checked.name()).answered_right;
    ReportedExercise exercise{std::move(checked), answered};
    reported.exercises.push_back(std::move(exercise));
  });
  progress_bar.clear();
  add_untouched_before("");

  if (const std::string reason = write_file(options.html, report_page(reported)); !reason.empty())
    throw std::runtime_error(
        fmt::format("The page cannot be written to {} ({}).", printable(options.html.string()), reason));
  fmt::print("The page is in {}.\n", printable(options.html.string()));
  return all_passed;
}

}  // namespace workbook
