#include "checker/commands/check_exercise.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/progress.hpp"
#include "checker/messages/plotting.hpp"
#include "checker/report/console.hpp"
#include "checker/report/json_report.hpp"
#include "checker/report/overlay.hpp"
#include "checker/report/progress_bar.hpp"
#include "checker/report/terminal_picture.hpp"
#include "checker/report/terminal_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace workbook {

namespace {

/// Verdicts on a file elsewhere, or with another seed, are no progress.
bool counts_as_progress(const CheckOptions& options) { return !options.file && options.seed == 1; }

/// What --plot asks for. A plot that fails changes no verdict.
void draw(const Course& course, const Checked& checked, PictureKind picture, const Console& console, bool to_terminal) {
  if (!checked.executable) return;
  try {
    const Overlay overlay = overlay_of(checked);
    const auto files = draw_overlay(overlay, plots_directory(course), checked.exercise.name());
    if (!to_terminal) return;
    fmt::print("{}  Plot   {}\n",
               terminal_picture(picture, overlay, files, plots_directory(course), console, picture_space(console)),
               files.front().string());
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
  }
}

}  // namespace

int check(const Course& course, const CheckOptions& options) {
  const std::vector<Exercise> exercises = course.choose(options.names);
  if (options.file && exercises.size() != 1) {
    fmt::print(stderr, "{}\n", messages::file_needs_one_exercise("check"));
    return wrong_usage;
  }
  const Toolchain toolchain = read_toolchain(course.toolchain_file());
  const Console console = Console::of_standard_output();
  const PictureKind picture = options.plot && !options.json
                                  ? choose_picture(options.picture, exercises.size(), traits_of_this_terminal(console))
                                  : PictureKind::none;
  Progress progress(course.progress_file());
  std::map<std::string, LectureReference> references;
  std::vector<Checked> results;
  {
    ProgressBar progress_bar(!options.json);
    for (std::size_t i = 0; i < exercises.size(); ++i) {
      const Exercise& exercise = exercises[i];
      progress_bar.show(i, exercises.size(), exercise.name());
      if (!references.contains(exercise.lecture())) {
        references.emplace(exercise.lecture(), course.reference(exercise.lecture(), options.seed));
      }
      const ExerciseReference& reference = references.at(exercise.lecture()).exercise(exercise.name());
      const std::filesystem::path file = options.file.value_or(course.student_file(exercise));
      const std::string source = fingerprint(file);
      results.push_back(check_exercise(course, toolchain, exercise, reference, file));
      const Checked& checked = results.back();
      if (counts_as_progress(options) && checked.judgement.verdict != Verdict::checker_error) {
        progress.remember(exercise.name(), {to_string(checked.judgement.verdict), source});
      }
      progress_bar.clear();
      if (!options.json) fmt::print("{}", terminal_report(course, checked, console));
      if (options.plot) draw(course, checked, picture, console, !options.json);
      if (!options.json) std::fflush(stdout);
    }
  }

  if (options.json) {
    // What the student printed may hold bytes that are no text; they are replaced, not fatal.
    fmt::print("{}\n",
               json_report(results, options.seed).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else if (results.size() > 1) {
    fmt::print("\n{}\n", summary_line(results));
  }
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());

  const auto any = [&](auto condition) { return std::any_of(results.begin(), results.end(), condition); };
  if (any([](const Checked& checked) { return checked.judgement.verdict == Verdict::checker_error; }))
    return checker_failed;
  if (any([](const Checked& checked) { return !checked.judgement.passed(); })) return something_failed;
  return all_passed;
}

}  // namespace workbook
