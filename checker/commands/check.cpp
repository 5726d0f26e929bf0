// The commands check and plot.
#include "checker/commands/commands.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace workbook {

namespace {

/// What is drawn of one exercise, in words too. A plot that fails changes no verdict.
void draw(const Course& course, const CheckResult& checked, PictureKind picture, const Console& console,
          bool to_terminal) {
  if (checked.observation.sweep.empty()) return;
  try {
    const Overlay overlay = overlay_of(checked);
    const auto files = draw_overlay(overlay, course.plots(), checked.name());
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
  if (!program_on_path("gnuplot").empty()) return draw(course, checked, PictureKind::none, console, true);
  fmt::print("  Plot   {}\n", command("plot " + checked.name()));
}

/// What there is to do with a function that passes: it is offered, never demanded.
std::string after_pass(const Course& course, const Exercise& exercise, const Progress& progress,
                       const Console& console) {
  std::string text;
  const auto offer = [&](const std::string& label, const std::string& words, const std::string& arguments) {
    text += fmt::format("  {:<10}{}\n{:12}{}\n", label, console.wrapped(words, 12).substr(12), "", command(arguments));
  };
  if (const std::string example = example_that_calls(course, exercise); !example.empty())
    offer("Used in", fmt::format("“{}”, which your function computes now:", example), "examples " + exercise.lecture());
  offer("Route", "another way to the same result, and why it is the same:", "solution " + exercise.name());
  if (!progress.of(exercise.name()).answered_right)
    offer("Question", "which mistake another function makes:", "question " + exercise.name());
  return text;
}

int exit_status(const std::vector<CheckResult>& results) {
  if (!std::ranges::all_of(results, &CheckResult::is_judged)) return checker_failed;
  const auto passed = [](const CheckResult& checked) { return checked.judgement.passed(); };
  return std::ranges::all_of(results, passed) ? all_passed : something_failed;
}

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

}  // namespace

void warn(const Progress& progress) {
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());
}

std::string remember(Progress& progress, const CheckResult& checked) {
  const Verdict verdict = checked.judgement.verdict;
  const std::string values = has_values(verdict) ? checked.fingerprint_of_values() : "";
  if (!progress.remember(checked.name(), to_string(verdict), checked.source, values)) return "";
  return fmt::format("Your change has changed no value. `{}` shows the next hint.", command("hint " + checked.name()));
}

std::vector<CheckTask> tasks_of(const Course& course, const Options& options, bool is_drawn) {
  const std::vector<Exercise> exercises = course.choose(options.names);
  if ((options.file || options.case_name) && exercises.size() != 1)
    throw UsageError(
        fmt::format("--file and --case need one exercise, for example `{}`.", command("check EXERCISE --file FILE")));
  std::vector<CheckTask> tasks;
  for (const Exercise& exercise : exercises) {
    tasks.push_back(check_task(course, exercise, options.seed, options.file));
    tasks.back().is_always_drawn = is_drawn;
  }
  return tasks;
}

void set_stage(CheckTask& task, const Progress& progress) {
  if (!task.exercise.entry->is_problem() || task.is_elsewhere || progress.of(task.exercise.name()).hints_shown > 0)
    return;
  const int tries = progress.wrong_tries_before(task.exercise.name(), file_fingerprint(task.file));
  task.stage = std::min(1 + tries, CheckTask::last_stage);
}

std::size_t find_case(const ExerciseReference& exercise, const std::string& asked) {
  const std::vector<Case>& cases = exercise.cases;
  const std::string number = asked.substr(std::min(asked.find_first_not_of('0'), asked.size()));
  std::vector<std::string> known;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (number == std::to_string(i + 1) || asked == cases[i].name) return i;
    if (i < exercise.described_cases()) known.push_back(cases[i].name);
  }
  const std::string proposal = did_you_mean(asked, known);
  throw UsageError(fmt::format("{} has no case '{}'. {}", exercise.name, printable(asked),
                               proposal.empty() ? fmt::format("Its cases have the numbers 1 to {}; the first are: {}.",
                                                              cases.size(), fmt::join(known, "; "))
                                                : fmt::format("Did you mean '{}'?", proposal)));
}

void require_pictures(const fs::path& directory) {
  if (program_on_path("gnuplot").empty()) throw std::runtime_error(gnuplot_is_missing);
  if (const std::string trouble = folder_trouble(directory); !trouble.empty())
    throw UsageError(fmt::format("Pictures cannot be written into {} ({}); give another folder with --out.",
                                 shown_path(directory), trouble));
}

void require_page(const fs::path& file) {
  std::error_code ignored;
  const bool is_other = file.empty() || (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored));
  const std::string trouble = is_other ? "not an ordinary file" : place_trouble(file);
  if (!trouble.empty())
    throw UsageError(fmt::format("The page cannot be written to {} ({}); give --html another file.",
                                 printable(file.string()), trouble));
}

std::size_t copy_figures(const Course& course, const std::string& lecture, const fs::path& to) {
  const fs::path from = course.build().directory / "figures" / lecture;
  std::size_t count = 0;
  if (!fs::exists(from)) return count;
  fs::create_directories(to);
  for (const auto& picture : fs::directory_iterator(from)) {
    if (picture.path().filename() == "drawn") continue;  // the build's own mark
    fs::copy_file(picture.path(), to / picture.path().filename(), fs::copy_options::overwrite_existing);
    count += picture.path().extension() == ".svg" ? 1 : 0;
  }
  return count;
}

int check(const Course& course, const Options& options) {
  CheckContext context(course);
  std::vector<CheckTask> tasks = tasks_of(course, options, options.plot);
  Detail detail{options.full, {}};
  if (options.case_name) detail.case_index = find_case(context.reference(tasks.front()), *options.case_name);

  const Console console = Console::of_standard_output();
  const PictureKind picture =
      options.plot && !options.json ? choose_picture(options.picture, tasks.size(), console) : PictureKind::none;
  Progress progress(course.progress_file());
  for (CheckTask& task : tasks) set_stage(task, progress);
  std::vector<CheckResult> results;
  ProgressBar progress_bar(!options.json);
  std::size_t done = 0;
  bool has_room = true;  // for one more line
  const auto show_progress = [&] {
    if (done < tasks.size()) progress_bar.show(done, tasks.size(), tasks[done].exercise.name());
  };
  show_progress();
  check_all(context, tasks, [&](CheckResult checked) {
    ++done;
    const bool counts = checked.task.counts_as_progress() && checked.is_judged();
    const std::string remark = counts ? remember(progress, checked) : "";
    progress_bar.clear();
    if (options.started && !checked.is_started()) return;
    if (!options.json) {
      const Exercise& exercise = checked.task.exercise;
      const std::string text = terminal_report(checked, course, console, detail);
      has_room = std::ranges::count(text, '\n') < static_cast<std::ptrdiff_t>(brief_lines);
      fmt::print("{}", text);
      if (!remark.empty()) fmt::print("{}\n", console.wrapped(remark, 2));
      if (tasks.size() == 1 && !checked.is_started())
        fmt::print("{}\n  {}\n", console.wrapped(exercise.entry->task, 2),
                   notes_place(course, exercise, exercise.entry->notes, console, 2));
      if (tasks.size() == 1 && checked.judgement.passed() && checked.task.counts_as_progress())
        fmt::print("{}", after_pass(course, exercise, progress, console));
    }
    if (options.plot) {
      draw(course, checked, picture, console, !options.json);
    } else if (!options.json && tasks.size() == 1 && has_room) {
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
  warn(progress);
  return exit_status(results);
}

/// The solution beside a wrong answer of the judging, for a lecture.
static int plot_wrong(const Course& course, const std::vector<CheckTask>& tasks, const std::string& name,
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

int plot(const Course& course, const Options& options) {
  if (options.all && !options.names.empty()) throw UsageError("--all draws the whole course; leave out the names.");
  if (!options.all && options.names.empty())
    throw UsageError(fmt::format("Say which exercise to plot, for example `{}`, or --all.",
                                 command("plot " + course.exercises().front().name())));
  const std::vector<CheckTask> tasks = tasks_of(course, options, true);
  const fs::path directory = options.out.value_or(course.plots());
  require_pictures(directory);
  if (!options.wrong.empty()) return plot_wrong(course, tasks, options.wrong, directory);

  const Console console = Console::of_standard_output();
  const PictureKind picture = options.all ? PictureKind::none : choose_picture(options.picture, tasks.size(), console);
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

}  // namespace workbook
