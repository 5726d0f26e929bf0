#include "checker/commands/commands.hpp"
#include "checker/course/did_you_mean.hpp"
#include "checker/course/progress.hpp"
#include "checker/messages/plotting.hpp"
#include "checker/messages/program.hpp"
#include "checker/messages/reporting.hpp"
#include "checker/pipeline/checking.hpp"
#include "checker/report/console.hpp"
#include "checker/report/gnuplot_program.hpp"
#include "checker/report/json_report.hpp"
#include "checker/report/overlay.hpp"
#include "checker/report/progress_bar.hpp"
#include "checker/report/terminal_picture.hpp"
#include "checker/report/terminal_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace workbook {

namespace {

/// Verdicts on a file elsewhere, or with another seed, are no progress.
bool counts_as_progress(const CheckOptions& options) { return !options.file && options.seed == 1; }

/// What is drawn of one exercise. A plot that fails changes no verdict.
void draw(const Course& course, const Checked& checked, PictureKind picture, const Console& console, bool to_terminal) {
  if (!checked.executable) return;
  try {
    const Overlay overlay = overlay_of(checked);
    const auto files = draw_overlay(overlay, plots_directory(course), checked.exercise.name());
    if (!to_terminal) return;
    fmt::print("{}  {}   {}\n",
               terminal_picture(picture, overlay, files, plots_directory(course), console, picture_space(console)),
               messages::plot_label(), std::filesystem::proximate(files.front()).string());
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
  }
}

/// A wrong value is best seen as a picture. Where there is no gnuplot, `plot` says what to do.
void draw_unasked(const Course& course, const Checked& checked, const Console& console) {
  if (checked.judgement.verdict != Verdict::wrong_value) return;
  if (gnuplot_program().empty()) {
    fmt::print("  {}   {}\n", messages::plot_label(), messages::command("plot " + checked.exercise.name()));
  } else {
    draw(course, checked, PictureKind::none, console, true);
  }
}

/// Makes the case with that name the one that is shown. @throws UnknownName
void show_case(Checked& checked, const std::string& name) {
  const std::vector<Case>& cases = checked.reference->cases;
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& one) { return one.name == name; });
  if (found == cases.end()) {
    std::vector<std::string> known;
    for (const Case& one : cases) known.push_back(one.name);
    throw UnknownName(messages::no_such_case(checked.exercise.name(), name, did_you_mean(name, known), known));
  }
  const auto index = static_cast<std::size_t>(found - cases.begin());
  FirstFailure shown{index, std::nullopt};
  if (index < checked.observation.replies.size()) {
    const Reply& reply = checked.observation.replies[index];
    if (reply.ending == Ending::returned) shown.actual = reply.value;
  }
  checked.judgement.first_failure = shown;
}

}  // namespace

int check(const Course& course, const CheckOptions& options) {
  const std::vector<Exercise> exercises = course.choose(options.names);
  if (options.file && exercises.size() != 1) {
    fmt::print(stderr, "{}\n", messages::file_needs_one_exercise("check"));
    return wrong_usage;
  }
  if (options.case_name && exercises.size() != 1) {
    fmt::print(stderr, "{}\n", messages::case_needs_one_exercise());
    return wrong_usage;
  }
  Checking check_one(course, options.seed, options.file);
  const Console console = Console::of_standard_output();
  const PictureKind picture = options.plot && !options.json
                                  ? choose_picture(options.picture, exercises.size(), traits_of_this_terminal(console))
                                  : PictureKind::none;
  Progress progress(course.progress_file());
  std::vector<Checked> results;
  {
    ProgressBar progress_bar(!options.json);
    for (std::size_t i = 0; i < exercises.size(); ++i) {
      const Exercise& exercise = exercises[i];
      progress_bar.show(i, exercises.size(), exercise.name());
      const std::string source = fingerprint(check_one.file_of(exercise));
      Checked checked = check_one(exercise);
      if (counts_as_progress(options) && checked.judgement.verdict != Verdict::checker_error) {
        progress.remember(exercise.name(), {to_string(checked.judgement.verdict), source});
      }
      progress_bar.clear();
      if (options.started && checked.judgement.verdict == Verdict::not_started) continue;
      if (options.case_name) show_case(checked, *options.case_name);
      if (!options.json) {
        fmt::print("{}", terminal_report(course, checked, console,
                                         {.full = options.full, .one_case = options.case_name.has_value()}));
        std::fflush(stdout);
      }
      if (options.plot) {
        draw(course, checked, picture, console, !options.json);
      } else if (!options.json && exercises.size() == 1) {
        draw_unasked(course, checked, console);
      }
      results.push_back(std::move(checked));
    }
  }

  if (options.json) {
    // What the student printed may hold bytes that are no text; they are replaced, not fatal.
    fmt::print("{}\n",
               json_report(results, options.seed).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else if (results.size() > 1) {
    fmt::print("\n{}\n", summary_line(results));
  } else if (results.empty()) {
    fmt::print("{}\n", messages::nothing_started());
  }
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());

  const auto any = [&](auto condition) { return std::any_of(results.begin(), results.end(), condition); };
  if (any([](const Checked& checked) { return checked.judgement.verdict == Verdict::checker_error; }))
    return checker_failed;
  if (any([](const Checked& checked) { return !checked.judgement.passed(); })) return something_failed;
  return all_passed;
}

}  // namespace workbook
