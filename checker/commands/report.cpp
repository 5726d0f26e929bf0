#include "checker/commands/commands.hpp"
#include "checker/course/notes.hpp"
#include "checker/messages/plotting.hpp"
#include "checker/messages/report_page.hpp"
#include "checker/messages/reporting.hpp"
#include "checker/pipeline/checking.hpp"
#include "checker/report/gnuplot_program.hpp"
#include "checker/report/overlay.hpp"
#include "checker/report/progress_bar.hpp"
#include "checker/report/report_page.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <system_error>

namespace workbook {

namespace {

namespace fs = std::filesystem;

/// What stands in the way of the page, found before the long work begins. Returns all_passed if nothing does.
int refuse_place(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    fmt::print(stderr, "{}\n", messages::report_folder_missing(file.string(), folder.string()));
    return wrong_usage;
  }
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)) {
    fmt::print(stderr, "{}\n", messages::report_is_no_file(file.string()));
    return wrong_usage;
  }
  if (access(folder.c_str(), W_OK) != 0) {
    fmt::print(stderr, "{}\n", messages::report_not_written(file.string(), std::strerror(errno)));
    return checker_failed;
  }
  return all_passed;
}

/// The whole page or nothing: whoever reads the file meanwhile sees the old one. Returns the reason of a failure.
std::string write_at_once(const fs::path& file, const std::string& text) {
  const fs::path part = fmt::format("{}.{}.part", file.string(), getpid());
  std::error_code problem;
  {
    errno = 0;
    std::ofstream out(part, std::ios::binary);
    out << text;
    out.close();
    if (!out) problem.assign(errno == 0 ? EIO : errno, std::generic_category());
  }
  if (!problem) fs::rename(part, file, problem);
  std::error_code ignored;
  if (problem) fs::remove(part, ignored);
  return problem ? problem.message() : "";
}

std::string text_of(const fs::path& file) {
  std::error_code problem;
  // A pipe or a device would never end, and the checker has refused it already.
  if (!fs::is_regular_file(file, problem)) return "";
  constexpr std::size_t enough = std::size_t{1} << 20;
  std::string text(enough, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(enough));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

/// The plot, where the function could run at all. A plot that fails leaves the page without it.
void add_picture(const Course& course, ReportedExercise& reported) {
  const Checked& checked = reported.checked;
  if (!checked.executable || checked.judgement.verdict == Verdict::checker_error) return;
  try {
    const Overlay overlay = overlay_of(checked);
    if (overlay.student.empty()) return;  // the reference alone says nothing about the student
    reported.picture = overlay_as_svg(overlay, plots_directory(course), checked.exercise.name());
    reported.picture_description =
        messages::overlay_description(checked.exercise.name(), overlay.sweep->title, overlay.misconception);
  } catch (const std::runtime_error&) {
    reported.picture.clear();
  }
}

}  // namespace

int report(const Course& course, const ReportOptions& options) {
  const std::vector<Exercise> exercises = course.choose(options.names);
  if (options.file && exercises.size() != 1) {
    fmt::print(stderr, "{}\n", messages::file_needs_one_exercise("report --html PAGE"));
    return wrong_usage;
  }
  if (const int status = refuse_place(options.html); status != all_passed) return status;
  Checking check(course, options.seed, options.file);
  const bool has_gnuplot = !gnuplot_program().empty();

  ReportedCourse reported;
  reported.student = options.student;
  reported.date = fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr)));
  reported.seed = options.seed;
  if (!has_gnuplot) reported.picture_trouble = messages::report_without_pictures(messages::gnuplot_missing_for_plot());
  for (const Card& card : course.cards()) reported.headings.merge(read_headings(course.notes_file(card)));

  ProgressBar progress_bar;
  for (std::size_t i = 0; i < exercises.size(); ++i) {
    const Exercise& exercise = exercises[i];
    progress_bar.show(i, exercises.size(), exercise.name());
    ReportedExercise entry{.checked = check(exercise), .source = {}, .picture = {}, .picture_description = {}};
    if (entry.checked.judgement.verdict != Verdict::not_started) {
      entry.source = text_of(check.file_of(exercise));
      if (has_gnuplot) add_picture(course, entry);
    }
    reported.exercises.push_back(std::move(entry));
  }
  progress_bar.clear();

  if (const std::string reason = write_at_once(options.html, report_page(reported)); !reason.empty()) {
    fmt::print(stderr, "{}\n", messages::report_not_written(options.html.string(), reason));
    return checker_failed;
  }
  fmt::print("{}\n", messages::report_written(options.html.string()));
  return all_passed;
}

}  // namespace workbook
