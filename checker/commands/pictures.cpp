// The commands plot and figures.
#include "checker/base/console.hpp"
#include "checker/base/files.hpp"
#include "checker/base/text.hpp"
#include "checker/commands/built_programs.hpp"
#include "checker/commands/commands.hpp"
#include "checker/pipeline/check_job.hpp"
#include "checker/report/overlay.hpp"
#include "checker/report/progress_bar.hpp"
#include "checker/report/terminal_picture.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace workbook {

namespace {

namespace fs = std::filesystem;

/// @throws PlotError where no picture can be made
void require_pictures(const fs::path& directory) {
  if (program_on_path("gnuplot").empty()) throw PlotError(gnuplot_is_missing);
  std::error_code problem;
  fs::create_directories(directory, problem);
  if (!problem && access(directory.c_str(), W_OK) != 0) problem.assign(errno, std::generic_category());
  if (problem)
    throw PlotError(fmt::format("Pictures cannot be written into {} ({}); give another folder with --out.",
                                shown_path(directory), problem.message()));
}

/// Every figure of every lecture, copied; returns how many.
std::size_t copy_all_figures(const Course& course, const fs::path& directory,
                             const std::function<void(const std::string&, ExitStatus)>& complain) {
  std::size_t count = 0;
  for (const Card& card : course.cards()) {
    if (course.has_solutions() && !build_target(course, "figures_" + card.lecture).succeeded()) {
      complain(
          fmt::format("The figures of {} cannot be drawn; `ninja -C build/workbook figures` says why.", card.lecture),
          checker_failed);
      continue;
    }
    const std::size_t copied = copy_figures(course, card.lecture, directory / card.lecture);
    if (copied == 0)
      complain(fmt::format("The figures of {} are not in this copy of the workbook.", card.lecture), all_passed);
    count += copied;
  }
  return count;
}

constexpr int status_of_not_started = 3;  // as lectures/support/figure.hpp has it

Outcome draw_figure(const std::string& program, const fs::path& directory, const std::string& name, double seconds) {
  const fs::path picture = directory / (name + ".svg");
  std::error_code ignored;
  fs::remove(picture, ignored);
  const FinishedProgram finished =
      run_with_path(program, {directory.string(), name}, std::chrono::duration<double>(seconds));
  if (finished.out_of_time) return {fmt::format("not finished after {:g} s; perhaps a loop never ends", seconds)};
  if (finished.end.signal != 0)
    return {fmt::format("a function of yours crashed ({})", strsignal(finished.end.signal))};
  if (finished.succeeded())
    return {fs::exists(picture, ignored) ? "" : "a function of yours ended the program; remove calls of exit()"};
  // The last line says "NAME: why".
  const std::vector<std::string> lines = lines_of(finished.output);
  const bool has_reason = !lines.empty() && lines.back().starts_with(name + ": ");
  return {has_reason ? shortened(printable(lines.back().substr(name.size() + 2)), 300) : "failed without a reason",
          finished.end.exit_status == status_of_not_started};
}

}  // namespace

int plot(const Course& course, const Options& options) {
  if (options.all && !options.names.empty()) throw UsageError("--all draws the whole course; leave out the names.");
  if (!options.all && options.names.empty())
    throw UsageError(fmt::format("Say which exercise to plot, for example `{}`, or --all.",
                                 command("plot " + course.exercises().front().name())));
  const std::vector<CheckTask> tasks = tasks_of(course, options);
  const fs::path directory = options.out.value_or(plots_directory(course));
  require_pictures(directory);

  const Console console = Console::of_standard_output();
  const PictureKind picture =
      options.all ? PictureKind::none : choose_picture(options.picture, tasks.size(), traits_of_this_terminal(console));
  CheckContext context(course);
  int worst = all_passed;
  ProgressBar progress_bar;
  const auto complain = [&](const std::string& sentence, ExitStatus status) {
    progress_bar.clear();
    fmt::print(stderr, "{}\n", sentence);
    worst = std::max<int>(worst, status);
  };
  std::size_t done = 0;
  std::size_t drawn = 0;
  check_all(context, tasks, [&](const CheckResult& checked) {
    if (tasks.size() > 1) progress_bar.show(++done, tasks.size(), checked.name());
    if (!checked.is_judged()) return complain(checked.judgement.message, checker_failed);
    try {
      const Overlay overlay = overlay_of(checked);
      const fs::path folder = options.all ? directory / "overlays" / checked.task.exercise.lecture() : directory;
      const std::vector<fs::path> files = draw_overlay(overlay, folder, checked.name());
      ++drawn;
      progress_bar.clear();
      fmt::print("{}", terminal_picture(picture, overlay, files.back(), console));
      for (const fs::path& file : files)
        if (!options.all) fmt::print("{}\n", file.string());
      if (!overlay.student.empty()) return;
      worst = std::max<int>(worst, something_failed);
      fmt::print("{}\n", console.wrapped(fmt::format("{}: only the reference is drawn, because your function gave no "
                                                     "value. {}",
                                                     checked.name(), checked.judgement.message)));
    } catch (const std::runtime_error& problem) {
      complain(problem.what(), checker_failed);
    }
  });
  if (options.all) {
    const std::size_t figures = copy_all_figures(course, directory / "figures", complain);
    fmt::print("{} and {}, each as SVG and PNG, are in\n  {}\n", plural(drawn, "overlay"), plural(figures, "figure"),
               shown_path(directory));
  }
  return worst;
}

int figures(const Course& course, const Options& options) {
  const std::string lecture = course.find(options.name).front().lecture();
  const fs::path directory = options.out.value_or(course.scratch() / "figures_of_the_student" / lecture);
  require_pictures(directory);
  const std::string program = student_program(course, "draw_of_the_student_" + lecture, "figures of " + lecture);
  if (program.empty()) return something_failed;

  const FinishedProgram listed = run_with_path(program, {"--list"}, std::chrono::seconds(10));
  const std::vector<std::string> names = lines_of(listed.output);
  const Console console = Console::of_standard_output();
  if (!listed.succeeded() || names.empty()) {
    fmt::print("{}\n", console.wrapped(fmt::format("The program of the figures ends before it draws anything, because "
                                                   "code of yours runs before main(); `{}` finds it.",
                                                   command("check " + lecture))));
    return something_failed;
  }
  std::size_t drawn = 0;
  ProgressBar progress_bar;
  for (std::size_t i = 0; i < names.size(); ++i) {
    progress_bar.show(i, names.size(), names[i]);
    const Outcome outcome = draw_figure(program, directory, names[i], options.seconds_per_figure);
    progress_bar.clear();
    drawn += outcome.is_good() ? 1 : 0;
    print_outcome(console, names[i], outcome);
  }
  fmt::print("\n{} of {} figures of {} are drawn with your functions.\n  {}\n", drawn, names.size(), lecture,
             shown_path(directory));
  return drawn == names.size() ? all_passed : something_failed;
}

}  // namespace workbook
