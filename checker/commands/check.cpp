#include "checker/base/console.hpp"
#include "checker/base/files.hpp"
#include "checker/base/text.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/did_you_mean.hpp"
#include "checker/course/progress.hpp"
#include "checker/pipeline/check_job.hpp"
#include "checker/report/json_report.hpp"
#include "checker/report/overlay.hpp"
#include "checker/report/progress_bar.hpp"
#include "checker/report/terminal_picture.hpp"
#include "checker/report/terminal_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace workbook {

namespace {

/// What is drawn of one exercise. A plot that fails changes no verdict.
void draw(const Course& course, const CheckResult& checked, PictureKind picture, const Console& console,
          bool to_terminal) {
  if (checked.executable.empty()) return;
  try {
    const Overlay overlay = overlay_of(checked);
    const auto files = draw_overlay(overlay, plots_directory(course), checked.name());
    if (!to_terminal) return;
    fmt::print("{}  Plot   {}\n", terminal_picture(picture, overlay, files.back(), console), shown_path(files.front()));
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
  }
}

/// A wrong value is best seen as a picture. Where there is no gnuplot, `plot` says what to do.
void draw_unasked(const Course& course, const CheckResult& checked, const Console& console) {
  if (checked.judgement.verdict != Verdict::wrong_value) return;
  std::fflush(stdout);  // the verdict does not wait for its picture
  if (program_on_path("gnuplot").empty()) {
    fmt::print("  Plot   {}\n", command("plot " + checked.name()));
  } else {
    draw(course, checked, PictureKind::none, console, true);
  }
}

/// The case of that number, counted from 1, or name. @throws UnknownName
std::size_t find_case(const ExerciseReference& exercise, const std::string& asked) {
  const std::vector<Case>& cases = exercise.cases;
  std::size_t number = 0;
  const auto [end, problem] = std::from_chars(asked.data(), asked.data() + asked.size(), number);
  if (problem == std::errc() && end == asked.data() + asked.size() && number >= 1 && number <= cases.size())
    return number - 1;
  const auto found = std::ranges::find(cases, asked, &Case::name);
  if (found != cases.end()) return static_cast<std::size_t>(found - cases.begin());
  std::vector<std::string> known;
  for (std::size_t i = 0; i < exercise.described_cases(); ++i) known.push_back(cases[i].name);
  const std::string proposal = did_you_mean(asked, known);
  throw UnknownName(fmt::format("{} has no case '{}'. {}", exercise.name, printable(asked),
                                proposal.empty() ? fmt::format("Its cases have the numbers 1 to {}; the first are: {}.",
                                                               cases.size(), fmt::join(known, "; "))
                                                 : fmt::format("Did you mean '{}'?", proposal)));
}

int exit_status(const std::vector<CheckResult>& results) {
  if (!std::ranges::all_of(results, &CheckResult::is_judged)) return checker_failed;
  const auto passed = [](const CheckResult& checked) { return checked.judgement.passed(); };
  return std::ranges::all_of(results, passed) ? all_passed : something_failed;
}

}  // namespace

std::vector<CheckTask> tasks_of(const Course& course, const Options& options) {
  const std::vector<Exercise> exercises = course.choose(options.names);
  if ((options.file || options.case_name) && exercises.size() != 1)
    throw UsageError(
        fmt::format("--file and --case need one exercise, for example `{}`.", command("check EXERCISE --file FILE")));
  std::vector<CheckTask> tasks;
  tasks.reserve(exercises.size());
  for (const Exercise& exercise : exercises) tasks.push_back(check_task(course, exercise, options.seed, options.file));
  return tasks;
}

int check(const Course& course, const Options& options) {
  CheckContext context(course);
  const std::vector<CheckTask> tasks = tasks_of(course, options);
  Detail detail{options.full, {}};
  if (options.case_name) detail.case_index = find_case(context.reference(tasks.front()), *options.case_name);

  const Console console = Console::of_standard_output();
  const PictureKind picture = options.plot && !options.json
                                  ? choose_picture(options.picture, tasks.size(), traits_of_this_terminal(console))
                                  : PictureKind::none;
  Progress progress(course.progress_file());
  std::vector<CheckResult> results;
  ProgressBar progress_bar(!options.json);
  std::size_t done = 0;
  const auto show_progress = [&] {
    if (done < tasks.size()) progress_bar.show(done, tasks.size(), tasks[done].exercise.name());
  };
  show_progress();
  check_all(context, tasks, [&](CheckResult checked) {
    ++done;
    if (checked.task.counts_as_progress() && checked.is_judged())
      progress.remember(checked.name(), {to_string(checked.judgement.verdict), fingerprint(checked.source)});
    progress_bar.clear();
    if (options.started && !checked.is_started()) return;
    if (!options.json) fmt::print("{}", terminal_report(checked, course, console, detail));
    if (options.plot) {
      draw(course, checked, picture, console, !options.json);
    } else if (!options.json && tasks.size() == 1) {
      draw_unasked(course, checked, console);
    }
    std::fflush(stdout);
    results.push_back(std::move(checked));
    show_progress();
  });
  progress_bar.clear();

  if (options.json) {
    fmt::print("{}\n", json_report(results, options.seed));
  } else if (results.size() > 1) {
    fmt::print("\n{}\n", summary_line(results));
  } else if (results.empty()) {
    fmt::print("No exercise is started, so there was nothing to check.\n");
  }
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());
  return exit_status(results);
}

}  // namespace workbook
