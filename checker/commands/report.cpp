#include "checker/base/files.hpp"
#include "checker/base/text.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/notes.hpp"
#include "checker/pipeline/check_job.hpp"
#include "checker/report/overlay.hpp"
#include "checker/report/progress_bar.hpp"
#include "checker/report/report_page.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>

namespace workbook {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
  throw std::runtime_error(fmt::format("The page cannot be written to {} ({}); give --html another file.",
                                       printable(file.string()), reason));
}

/// Finds out before the long work begins.
void require_place(const fs::path& file) {
  std::error_code problem;
  const fs::path folder = fs::absolute(file).parent_path();
  fs::create_directories(folder, problem);
  if (problem) refuse(file, problem.message());
  if (fs::exists(file, problem) && !fs::is_regular_file(file, problem)) refuse(file, "not an ordinary file");
  if (access(folder.c_str(), W_OK) != 0) refuse(file, std::strerror(errno));
}

/// The plot, where the function gave a value. A plot that fails leaves the page without it.
void add_picture(const Course& course, ReportedExercise& reported) {
  const CheckResult& checked = reported.checked;
  if (checked.executable.empty() || !checked.is_judged()) return;
  try {
    const Overlay overlay = overlay_of(checked);
    if (overlay.student.empty()) return;
    const std::string terminal = "svg noenhanced size 640,512 font 'Helvetica,14' background rgb 'white'";
    reported.picture = drawn_overlay(overlay, terminal, plots_directory(course));
    reported.picture_description =
        fmt::format("Plot of {}: {}. The submitted function on the reference{}; below, the difference.", checked.name(),
                    overlay.sweep->title,
                    overlay.misconception.empty() ? "" : fmt::format(" and on “{}”", overlay.misconception_name));
  } catch (const std::runtime_error&) {
    reported.picture.clear();
  }
}

}  // namespace

int report(const Course& course, const Options& options) {
  const std::vector<CheckTask> tasks = tasks_of(course, options);
  require_place(options.html);

  ReportedCourse reported;
  reported.student = options.student;
  reported.date = fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr)));
  reported.seed = options.seed;
  const bool has_gnuplot = !program_on_path("gnuplot").empty();
  if (!has_gnuplot) reported.picture_trouble = gnuplot_is_missing;
  for (const Card& card : course.cards()) reported.headings.merge(read_headings(course.notes_file(card)));

  CheckContext context(course);
  ProgressBar progress_bar;
  check_all(context, tasks, [&](CheckResult checked) {
    progress_bar.show(reported.exercises.size(), tasks.size(), checked.name());
    ReportedExercise exercise{std::move(checked), {}, {}};
    if (has_gnuplot) add_picture(course, exercise);
    reported.exercises.push_back(std::move(exercise));
  });
  progress_bar.clear();

  if (const std::string reason = write_file(options.html, report_page(reported)); !reason.empty())
    refuse(options.html, reason);
  fmt::print("The page is in {}.\n", printable(options.html.string()));
  return all_passed;
}

}  // namespace workbook
