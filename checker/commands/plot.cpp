#include "checker/commands/built_programs.hpp"
#include "checker/commands/commands.hpp"
#include "checker/commands/picture_folder.hpp"
#include "checker/messages/plotting.hpp"
#include "checker/messages/reporting.hpp"
#include "checker/pipeline/checking.hpp"
#include "checker/report/gnuplot_program.hpp"
#include "checker/report/overlay.hpp"
#include "checker/report/progress_bar.hpp"
#include "checker/report/terminal_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace workbook {

namespace {

namespace fs = std::filesystem;

int plot_some(const Course& course, const PlotOptions& options, const std::vector<Exercise>& exercises) {
  const fs::path directory = options.out.value_or(plots_directory(course));
  const Console console = Console::of_standard_output();
  const PictureKind picture = choose_picture(options.picture, exercises.size(), traits_of_this_terminal(console));
  Checking check(course, options.seed, options.file);
  int worst = all_passed;
  for (const Exercise& exercise : exercises) {
    const Checked checked = check(exercise);
    if (checked.judgement.verdict == Verdict::checker_error) {
      fmt::print(stderr, "{}\n", checked.judgement.message);
      return checker_failed;
    }
    const Overlay overlay = overlay_of(checked);
    try {
      const std::vector<fs::path> files = draw_overlay(overlay, directory, exercise.name());
      fmt::print("{}", terminal_picture(picture, overlay, files, directory, console, picture_space(console)));
      for (const fs::path& file : files) fmt::print("{}\n", file.string());
    } catch (const PlotError& problem) {
      fmt::print(stderr, "{}\n", problem.what());
      return checker_failed;
    }
    if (overlay.student.empty()) {
      fmt::print("{}\n", messages::only_reference_drawn(exercise.name(), checked.judgement.message));
      worst = something_failed;
    }
  }
  return worst;
}

/// Copies the pictures of a lecture. Returns how many figures there are.
std::size_t copy_figures(const fs::path& from, const fs::path& to) {
  std::error_code ignored;
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(from, ignored)) {
    const std::string kind = entry.path().extension().string();
    if (kind != ".svg" && kind != ".png" && kind != ".gif") continue;
    fs::create_directories(to);
    fs::copy_file(entry.path(), to / entry.path().filename(), fs::copy_options::overwrite_existing);
    count += kind == ".svg" ? 1 : 0;
  }
  return count;
}

int plot_all(const Course& course, const PlotOptions& options) {
  const fs::path directory = options.out.value_or(plots_directory(course));
  if (!make_picture_folder(directory)) return checker_failed;
  if (gnuplot_program().empty()) {
    fmt::print(stderr, "{}\n", messages::gnuplot_missing_for_plot());
    return checker_failed;
  }
  const std::vector<Exercise> exercises = course.exercises();
  const std::size_t pieces = exercises.size() + course.cards().size();
  int worst = all_passed;
  std::size_t done = 0;
  std::size_t overlays = 0;
  std::size_t lecture_figures = 0;
  std::vector<std::string> without_value;
  ProgressBar progress_bar;
  const auto complain = [&](const std::string& sentence, int status) {
    progress_bar.clear();
    fmt::print(stderr, "{}\n", sentence);
    worst = std::max(worst, status);
  };

  Checking check(course, options.seed, options.file);
  for (const Exercise& exercise : exercises) {
    progress_bar.show(done++, pieces, exercise.name());
    const Checked checked = check(exercise);
    if (checked.judgement.verdict == Verdict::checker_error) {
      complain(checked.judgement.message, checker_failed);
      continue;
    }
    try {
      const Overlay overlay = overlay_of(checked);
      draw_overlay(overlay, directory / "overlays" / exercise.lecture(), exercise.name());
      ++overlays;
      if (overlay.student.empty()) without_value.push_back(exercise.name());
    } catch (const PlotError& trouble) {
      complain(trouble.what(), checker_failed);
    }
  }
  for (const Card& card : course.cards()) {
    progress_bar.show(done++, pieces, messages::figures_of_lecture(card.lecture));
    if (course.has_solutions() && !build_target(course, "figures_" + card.lecture).succeeded()) {
      complain(messages::lecture_figures_not_built(card.lecture), checker_failed);
      continue;
    }
    const fs::path folder = directory / "figures" / card.lecture;
    try {
      const std::size_t count = copy_figures(course.build() / "figures" / card.lecture, folder);
      if (count == 0) complain(messages::no_lecture_figures(card.lecture), all_passed);
      lecture_figures += count;
    } catch (const fs::filesystem_error& trouble) {
      complain(messages::folder_not_usable(folder.string(), trouble.code().message()), checker_failed);
    }
  }
  progress_bar.clear();

  const Console console = Console::of_standard_output();
  if (!without_value.empty()) {
    worst = std::max<int>(worst, something_failed);
    fmt::print("{}\n", console.wrapped(messages::only_references_drawn(without_value)));
  }
  fmt::print("{}\n", messages::pictures_done(overlays, lecture_figures, directory.string()));
  return worst;
}

}  // namespace

int plot(const Course& course, const PlotOptions& options) {
  if (options.all && !options.names.empty()) {
    fmt::print(stderr, "{}\n", messages::all_takes_no_names());
    return wrong_usage;
  }
  if (options.file && (options.all || course.choose(options.names).size() != 1)) {
    fmt::print(stderr, "{}\n", messages::file_needs_one_exercise("plot"));
    return wrong_usage;
  }
  if (options.all) return plot_all(course, options);
  if (options.names.empty()) {
    fmt::print(stderr, "{}\n", messages::say_what_to_plot(course.exercises().front().name()));
    return wrong_usage;
  }
  return plot_some(course, options, course.choose(options.names));
}

}  // namespace workbook
