#include "checker/commands/on_demand/student_programs.hpp"

#include <cstring>

namespace workbook {

namespace {

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

int figures(const Course& course, const FiguresOptions& options) {
  const std::string lecture = options.lecture;
  const fs::path directory = options.out.value_or(course.scratch() / "figures_of_the_student" / lecture);
  require_pictures(directory);
  const std::string program = student_program(course, {"draw_of_the_student_" + lecture,
                                                       course.lectures() / lecture / "figures.cpp",
                                                       {"figures_objects_" + lecture, "workbook_figure"},
                                                       "figures of " + lecture});
  if (program.empty()) return something_failed;

  const FinishedProgram listed = run_with_path(program, {"--list"}, std::chrono::seconds(10));
  const std::vector<std::string> names = lines_of(listed.output);
  if (!listed.succeeded() || names.empty())
    return stop(
        "The program of the figures ends before it draws anything, because "
        "code of yours runs before main(); `{}` finds it.",
        command("check " + lecture));
  std::size_t drawn = 0;
  ProgressBar progress_bar;
  for (std::size_t i = 0; i < names.size(); ++i) {
    progress_bar.show(i, names.size(), names[i]);
    const Outcome outcome = draw_figure(program, directory, names[i], options.seconds);
    progress_bar.clear();
    drawn += outcome.trouble.empty() ? 1 : 0;
    print_outcome(names[i], outcome);
  }
  fmt::print("\n{} of {} figures of {} are drawn with your functions.\n  {}\n", drawn, names.size(), lecture,
             shown_path(directory));
  return drawn == names.size() ? all_passed : something_failed;
}

}  // namespace workbook
