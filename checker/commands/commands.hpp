/// @file
/// What several commands do.
#pragma once

#include "checker/commands/command.hpp"
#include "checker/course/release.hpp"
#include "checker/report/reports.hpp"

namespace workbook {

/// Prints a text, as fmt formats it, in lines that fit the terminal.
template <class... Parts>
void say(fmt::format_string<Parts...> text, Parts&&... parts) {
  const std::string whole = fmt::format(text, std::forward<Parts>(parts)...);
  fmt::print("{}\n", Console::of_standard_output().wrapped(whole));
}

/// The same, where it says why there is nothing else.
template <class... Parts>
int stop(fmt::format_string<Parts...> text, Parts&&... parts) {
  say(text, std::forward<Parts>(parts)...);
  return something_failed;
}

/// Where the progress could not be read or saved, says so on standard error.
void warn(const Progress& progress);

/// Keeps a verdict. Returns what is to be said of it, or "".
std::string remember(Progress& progress, const CheckResult& checked);

/// What is to be checked.
struct Chosen {
  std::vector<std::string> names;        ///< exercises and lectures; none: the whole course
  std::optional<fs::path> file;          ///< instead of the exercise's own
  std::optional<std::uint64_t> seed;     ///< none: that of the course
  std::optional<std::string> case_name;  ///< show this case in full, whether it passes or not
};

/// @param is_drawn  each gets a plot. @throws UsageError
std::vector<CheckTask> tasks_of(const Course& course, const Chosen& chosen, bool is_drawn);

/// Tells of a problem in an exercise's own file only what its try deserves. A file elsewhere is an instructor's matter.
void set_stage(CheckTask& task, const Progress& progress);

/// The case of that number, counted from 1, or name. @throws UsageError
std::size_t find_case(const ExerciseReference& exercise, const std::string& asked);

/// "k = 1, x = (0, 1, 0)"
std::string inputs_text(const ExerciseReference& exercise, const Case& one);

/// The exercise that `review` would ask for today; "" if none is due.
std::string due_for_review(const Course& course, const Progress& progress);

/// What an update leaves to the reader to look at.
void print_update(const Release& now, const Release& before, const UpdateResult& result);

// --- pictures

/// Draws one exercise. Returns what to print of it: the picture, where it is to be shown, and its file. A plot that
/// fails changes no verdict.
std::string draw(const Course& course, const CheckResult& checked, bool is_shown, const Console& console);

/// @throws std::runtime_error where no picture can be made, UsageError where none can be kept
void require_pictures(const fs::path& directory);

/// Copies the pictures of a lecture into a folder; returns how many figures they show. @throws fs::filesystem_error
std::size_t copy_figures(const Course& course, const std::string& lecture, const fs::path& to);

}  // namespace workbook
