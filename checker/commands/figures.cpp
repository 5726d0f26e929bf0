#include "checker/base/printable.hpp"
#include "checker/commands/built_programs.hpp"
#include "checker/commands/commands.hpp"
#include "checker/commands/picture_folder.hpp"
#include "checker/messages/plotting.hpp"
#include "checker/report/gnuplot_program.hpp"
#include "checker/report/progress_bar.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstring>
#include <sstream>

namespace workbook {

namespace {

namespace fs = std::filesystem;

/// As lectures/support/figure.hpp has it: the programs say by their exit status how a figure came out.
constexpr int status_of_not_started = 3;

constexpr std::size_t longest_reason = 300;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

/// The reason in the last line, "NAME: why".
std::string reason_in(const std::string& output, const std::string& figure) {
  const std::vector<std::string> lines = lines_of(output);
  if (lines.empty() || !lines.back().starts_with(figure + ": ")) return "";
  return shortened(printable(lines.back().substr(figure.size() + 2)), longest_reason);
}

struct DrawnFigure {
  bool drawn = false;
  bool not_started = false;
  std::string words;  ///< the path, or what went wrong
};

DrawnFigure draw(const std::string& program, const fs::path& directory, const std::string& name, double seconds) {
  const fs::path picture = directory / (name + ".svg");
  std::error_code ignored;
  fs::remove(picture, ignored);
  const FinishedProgram finished =
      run_with_path(program, {directory.string(), name}, std::chrono::duration<double>(seconds));
  if (finished.out_of_time) return {.words = messages::figure_out_of_time(seconds)};
  if (finished.end.signal != 0) return {.words = messages::figure_crashed(strsignal(finished.end.signal))};
  if (finished.end.exit_status == status_of_not_started)
    return {.not_started = true, .words = messages::figure_not_started()};
  if (finished.end.exit_status != 0) return {.words = messages::figure_failed(reason_in(finished.output, name))};
  if (!fs::exists(picture, ignored)) return {.words = messages::figure_ended_early()};
  return {.drawn = true, .words = picture.string()};
}

/// Builds the program, or says why that is not possible. Returns all_passed if it is there.
int build_program(const Course& course, const std::string& lecture, const std::string& target) {
  const FinishedProgram built = build_target(course, target);
  if (built.succeeded()) return all_passed;
  const std::vector<std::string> files = files_with_errors(built.output);
  if (files.empty()) {
    fmt::print(stderr, "{}\n{}\n", built.output, messages::figures_not_built(lecture));
    return checker_failed;
  }
  fmt::print("{}\n", messages::figures_need_compiling());
  for (const std::string& file : files) fmt::print("  {}\n", file);
  return something_failed;
}

}  // namespace

int figures(const Course& course, const FiguresOptions& options) {
  const std::string lecture = course.find(options.lecture).front().lecture();
  const fs::path directory = options.out.value_or(course.scratch() / "figures_of_the_student" / lecture);
  const Console console = Console::of_standard_output();
  if (gnuplot_program().empty()) {
    fmt::print(stderr, "{}\n", messages::gnuplot_missing_for_figures());
    return checker_failed;
  }
  if (!make_picture_folder(directory)) return checker_failed;
  const std::string target = "draw_of_the_student_" + lecture;
  if (const int status = build_program(course, lecture, target); status != all_passed) return status;

  const std::string program = lecture_program(course, target).string();
  const FinishedProgram listed = run_with_path(program, {"--list"}, std::chrono::seconds(10));
  const std::vector<std::string> names = lines_of(listed.output);
  if (!listed.succeeded() || names.empty()) {
    fmt::print("{}\n", console.wrapped(messages::figures_not_listed(lecture)));
    return something_failed;
  }
  std::size_t drawn = 0;
  ProgressBar progress_bar;
  for (std::size_t i = 0; i < names.size(); ++i) {
    progress_bar.show(i, names.size(), names[i]);
    const DrawnFigure figure = draw(program, directory, names[i], options.seconds_per_figure);
    progress_bar.clear();
    drawn += figure.drawn ? 1 : 0;
    const Style style = figure.drawn ? Style::good : figure.not_started ? Style::quiet : Style::bad;
    const std::string mark = console.mark(figure.drawn ? "✓" : figure.not_started ? "·" : "✗", style);
    // A path is not broken into lines: it is there to be copied.
    if (figure.drawn) {
      fmt::print("{}{}: {}\n", mark, names[i], figure.words);
    } else {
      const std::size_t indent = mark.empty() ? 0 : 2;
      fmt::print("{}{}\n", mark, console.wrapped(names[i] + ": " + figure.words, indent).substr(indent));
    }
    std::fflush(stdout);
  }
  fmt::print("\n{}\n", messages::figures_drawn(drawn, names.size(), lecture));
  return drawn == names.size() ? all_passed : something_failed;
}

}  // namespace workbook
