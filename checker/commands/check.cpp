#include "checker/commands/commands.hpp"

#include <algorithm>

namespace workbook {

namespace {

struct CheckOptions : Chosen {
  bool started = false, full = false, json = false, plot = false;
};

/// A wrong value is best seen as a picture. Where there is no gnuplot, `plot` says what to do.
void draw_unasked(const Course& course, const CheckResult& checked, const Console& console) {
  if (checked.judgement.verdict != Verdict::wrong_value) return;
  std::fflush(stdout);  // the verdict does not wait for its picture
  const bool can_draw = !program_on_path("gnuplot").empty();
  fmt::print("{}", can_draw ? draw(course, checked, false, console)
                            : fmt::format("  Plot   {}\n", command("plot " + checked.name())));
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

int check(const Course& course, const CheckOptions& options) {
  CheckContext context(course);
  std::vector<CheckTask> tasks = tasks_of(course, options, options.plot);
  Detail detail{options.full, {}};
  if (options.case_name) detail.case_index = find_case(context.reference(tasks.front()), *options.case_name);

  const Console console = Console::of_standard_output();
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
  check_all(
      context, tasks,
      [&](CheckResult checked) {
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
          const std::string drawn =
              draw(course, checked, !options.json && shows_pictures(tasks.size(), console), console);
          if (!options.json) fmt::print("{}", drawn);
        } else if (!options.json && tasks.size() == 1 && has_room) {
          draw_unasked(course, checked, console);
        }
        std::fflush(stdout);
        results.push_back(std::move(checked));
        show_progress();
      },
      [&](const CheckJob& job) {
        const auto seconds = std::chrono::floor<std::chrono::seconds>(Clock::now() - job.begun()).count();
        const std::optional<CheckResult> judged = job.last_message();
        const bool is_explained = judged && !judged->judgement.passed();
        const std::string verdict =
            is_explained ? fmt::format(": {}, reason follows", in_words(to_string(judged->judgement.verdict))) : "";
        progress_bar.show(done, tasks.size(), fmt::format("{} s  {}{}", seconds, job.name(), verdict));
      });
  progress_bar.clear();

  if (options.json) {
    fmt::print("{}\n", json_report(results, options.seed.value_or(course.seed())));
  } else if (results.size() > 1) {
    fmt::print("\n{}\n", summary_line(results));
  } else if (results.empty()) {
    fmt::print("No exercise is started, so there was nothing to check.\n");
  }
  warn(progress);
  return exit_status(results);
}

}  // namespace

Command check_command() {
  const auto options = std::make_shared<CheckOptions>();
  return {"check",
          students,
          "Grade exercises and explain what is wrong\n\nCompiles each exercise, runs it in a process of its own on the "
          "cases of the reference results, and compares. A failure is explained as far as the reason is certain, with "
          "where to read; then come the inputs, the expected value and yours for the first failing case. Verdicts on "
          "the exercise's own file without --seed are saved as your progress.",
          {"check inertia_of_points", "check 3", "check 03 --started", "check inertia_of_points --case 2",
           "check inertia_of_points --file draft.cpp --plot", "check --seed 7 --json"},
          {names_parameter(options->names),
           own_file_parameter(options->file, &options->json),
           seed_parameter(options->seed),
           {"--case", "CASE", &options->case_name, "show this case in full, by number or name, even if it passes"},
           {"--started", "", &options->started, "leave out what is not started"},
           {"--full", "", &options->full, "show everything: all failing cases, long lists, all compiler messages"},
           {"--json", "", &options->json, "print one JSON document and nothing else"},
           {"--plot", "", &options->plot, "draw your curve on the reference, as SVG and PNG"}},
          with_options(options, &check),
          no_help_in_exam(options->names)};
}

}  // namespace workbook
