#include "checker/commands/commands.hpp"

namespace workbook {

namespace {

[[noreturn]] void refuse_page(const fs::path& file, const std::string& reason) {
  throw std::runtime_error(fmt::format("The page cannot be written to {} ({}); give --html another file.",
                                       printable(file.string()), reason));
}

/// The plot, where the function gave a value. A plot that fails leaves the page without it.
void add_picture(const Course& course, ReportedExercise& reported) {
  const CheckResult& checked = reported.checked;
  if (checked.executable.empty() || !checked.is_judged()) return;
  try {
    const Overlay overlay = overlay_of(checked);
    if (overlay.student.empty()) return;
    const std::string terminal = "svg noenhanced size 640,512 font 'Helvetica,14' background rgb 'white'";
    reported.picture = drawn_overlay(overlay, terminal, course.plots());
    reported.picture_description =
        fmt::format("Plot of {}: {}. The submitted function on the reference{}; below, the difference.", checked.name(),
                    overlay.sweep->title,
                    overlay.misconception.empty() ? "" : fmt::format(" and on “{}”", overlay.misconception_name));
  } catch (const std::runtime_error&) {  // there is none
  }
}

}  // namespace

int report(const Course& course, const Options& options) {
  const std::vector<CheckTask> tasks = tasks_of(course, options);
  std::error_code ignored;
  const std::string trouble = folder_trouble(fs::absolute(options.html).parent_path());
  if (!trouble.empty()) refuse_page(options.html, trouble);
  if (fs::exists(options.html, ignored) && !fs::is_regular_file(options.html, ignored))
    refuse_page(options.html, "not an ordinary file");

  ReportedCourse reported;
  reported.student = options.student;
  reported.date = current_day();
  reported.seed = options.seed;
  const bool has_gnuplot = !program_on_path("gnuplot").empty();
  if (!has_gnuplot) reported.picture_trouble = gnuplot_is_missing;
  for (const Card& card : course.cards()) reported.headings.merge(read_headings(course.notes_file(card)));

  CheckContext context(course);
  const Progress progress(course.progress_file());
  ProgressBar progress_bar;
  check_all(context, tasks, [&](CheckResult checked) {
    progress_bar.show(reported.exercises.size(), tasks.size(), checked.name());
    const auto answered = progress.of(checked.name()).answered_right;
    ReportedExercise exercise{std::move(checked), {}, {}, answered};
    if (has_gnuplot) add_picture(course, exercise);
    reported.exercises.push_back(std::move(exercise));
  });
  progress_bar.clear();

  if (const std::string reason = write_file(options.html, report_page(reported)); !reason.empty())
    refuse_page(options.html, reason);
  fmt::print("The page is in {}.\n", printable(options.html.string()));
  return all_passed;
}

}  // namespace workbook
