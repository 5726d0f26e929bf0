#include "checker/commands/commands.hpp"

#include <algorithm>

namespace workbook {

namespace {

struct PlotOptions : Chosen {
  bool all = false;
  std::string wrong;  ///< the wrong answer to draw beside the solution
  std::optional<fs::path> out;
};

/// Every figure of every lecture, copied; returns how many.
std::size_t copy_all_figures(const Course& course, const fs::path& directory,
                             const std::function<void(const std::string&, ExitStatus)>& complain) {
  std::size_t count = 0;
  for (const Card& card : course.cards()) {
    if (course.has_solutions() && !make(course.build(), {"figures_" + card.lecture}).succeeded()) {
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

/// The solution beside a wrong answer of the judging, for a lecture.
int plot_wrong(const Course& course, const std::vector<CheckTask>& tasks, const std::string& name,
               const fs::path& directory) {
  if (tasks.size() != 1) throw UsageError("--wrong needs one exercise.");
  if (!course.has_solutions()) throw UsageError("Wrong answers are drawn where the solutions are.");
  CheckContext context(course);
  CheckResult shown;
  shown.task = tasks.front();
  shown.reference = &context.reference(shown.task);
  std::vector<std::string> names;
  for (const Misconception& each : shown.reference->misconceptions) names.push_back(each.name);
  if (std::ranges::count(names, name) == 0)
    throw UsageError(
        fmt::format("{} has no wrong answer '{}'; it has {}.", shown.name(), printable(name), listed(names)));
  shown.reasons = {{ReasonKind::misconception, name, ""}};
  for (const fs::path& file : draw_overlay(overlay_of(shown), directory, shown.name() + "-" + name))
    fmt::print("{}\n", file.string());
  return all_passed;
}

int plot(const Course& course, const PlotOptions& options) {
  if (options.all && !options.names.empty()) throw UsageError("--all draws the whole course; leave out the names.");
  if (!options.all && options.names.empty())
    throw UsageError(fmt::format("Say which exercise to plot, for example `{}`, or --all.",
                                 command("plot " + course.exercises().front().name())));
  const std::vector<CheckTask> tasks = tasks_of(course, options, true);
  const fs::path directory = options.out.value_or(course.plots());
  require_pictures(directory);
  if (!options.wrong.empty()) return plot_wrong(course, tasks, options.wrong, directory);

  const Console console = Console::of_standard_output();
  const bool is_shown = !options.all && shows_pictures(tasks.size(), console);
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
      if (is_shown) fmt::print("{}", terminal_picture(overlay, files.back(), console));
      for (const fs::path& file : files)
        if (!options.all) fmt::print("{}\n", file.string());
      // In the tree of an instructor nothing is started.
      if (!overlay.student.empty() || (options.all && !checked.is_started())) return;
      worst = std::max<int>(worst, something_failed);
      say("{}: only the reference is drawn, because your function gave no "
          "value. {}",
          checked.name(), checked.judgement.message);
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

}  // namespace

Command plot_command() {
  const auto options = std::make_shared<PlotOptions>();
  return {
      "plot",
      students,
      "Draw your curve on the reference\n\nWrites an SVG and a PNG with your curve on the reference and the "
      "difference below, and shows the picture in the terminal: as graphics where chafa is installed and the "
      "terminal can show them, else as text. For instructors: --all --out DIR draws every exercise and copies every "
      "figure of the "
      "lectures, and --wrong draws a wrong answer, by its name in judging/, beside the solution.",
      {"plot inertia_of_points", "plot 03", "plot inertia_of_points --wrong plus_dyad", "plot --all --out pictures"},
      {names_parameter(options->names),
       {"--all", "", &options->all, "all plots, and the figures of every lecture"},
       {"--wrong", "NAME", &options->wrong, "this wrong answer of the judging beside the solution, for a lecture"},
       own_file_parameter(options->file),
       place_parameter("--out", "FOLDER", options->out, "the folder for the pictures"),
       seed_parameter(options->seed)},
      with_options(options, &plot),
      no_help_in_exam(options->names)};
}

}  // namespace workbook
