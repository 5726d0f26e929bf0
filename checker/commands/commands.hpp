/// @file
/// What the program can be asked to do. Every command returns the exit status.
#pragma once

#include "checker/course/release.hpp"
#include "checker/report/reports.hpp"

namespace workbook {

enum ExitStatus { all_passed = 0, something_failed = 1, wrong_usage = 2, checker_failed = 3 };

/// What the command line said; a command reads what it takes.
struct Options {
  std::vector<std::string> names;  ///< exercises and lectures; none: the whole course
  std::string name;                ///< one exercise or lecture; "": the command's own choice
  std::optional<fs::path> file;
  std::uint64_t seed = 1;  ///< that of the course, or another one
  bool is_seed_given = false;
  bool update = false;                   ///< the folder holds an earlier release
  std::string message;                   ///< what is new in a release
  std::optional<std::string> case_name;  ///< show this case in full, whether it passes or not
  bool started = false;                  ///< leave out what is not started
  bool full = false;                     ///< with all that the compiler says
  bool json = false;
  bool plot = false;
  std::string wrong;                     ///< the wrong answer to draw beside the solution
  bool all = false;                      ///< all hints, or all plots and figures
  std::vector<std::string> predictions;  ///< "4=0 0 1.5": a case and the numbers of the result
  std::string answer;                    ///< to the question on an exercise: "a", "b" or "c"; "": show the question
  int minutes = 0;                       ///< that an exam may take; 0: what its problems take together
  bool finish = false;                   ///< grade the exam that is running
  bool build_only = false;               ///< the program for a debugger, without the debugger
  bool now = false;                      ///< the solution of an exercise that does not pass yet
  PictureKind picture = PictureKind::automatic;
  std::optional<fs::path> out;  ///< folder for pictures, results of a class, or a copy
  double seconds_per_figure = 60.0;
  fs::path html;
  std::string student;   ///< whose page it is; may be empty
  fs::path submissions;  ///< of a class: a folder or a zip file
  std::optional<fs::path> roster, assignment, overrides;
  std::string attempts;                          ///< which one counts, "last" or "best"; "": they are not told apart
  std::vector<fs::path> references;              ///< reference results to judge by
  std::string only;                              ///< judge what has this verdict once more
  std::string shard;                             ///< "2/8": judge only this part of the class
  std::vector<fs::path> merged;                  ///< folders of such parts, to be joined
  std::string image = "rigid-body-workbook";     ///< of containers, with the workbook in it
  std::optional<fs::path> copy;                  ///< that students have
  bool who = false;                              ///< only say who has handed in what
  bool with_missing = false;                     ///< tables have rows also of students of whom something was not read
  double explain_minutes = 10.0;                 ///< for the reasons of all failures of one student
  bool allow_reduced = false;                    ///< grade strangers' files in the reduced sandbox
  int seeds = 3;                                 ///< how many seeds the workbook itself is checked with, from 1 on
  bool prove = false;                            ///< compare the record of typical bugs with a new proof
  bool record = false;                           ///< write that record
  bool mutants = false;                          ///< check it by small bugs in the solutions instead
  std::string new_name, new_lecture, signature;  ///< what a new lecture or exercise is to be
  fs::path program;                              ///< the file of the running program
  std::vector<std::string> typed;                ///< the words of the command line after the program's name
};

/// What each does stands in its help, in checker/commands/program/main.cpp.
using Command = int(const Course& course, const Options& options);
Command status, list, check, hint, solution, plot, report, reset;                    // exercises
Command figures, live, examples, try_out, debug, predict, question, review, update;  // the course
Command exam, watch, doctor, prepare, handout, export_recipe, grade, self_check, new_lecture, new_exercise;

// --- what several of them do

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

/// What the command line asks to check. @param is_drawn  each gets a plot. @throws UsageError
std::vector<CheckTask> tasks_of(const Course& course, const Options& options, bool is_drawn);

/// Tells of a problem in an exercise's own file only what its try deserves. A file elsewhere is an instructor's matter.
void set_stage(CheckTask& task, const Progress& progress);

/// The case of that number, counted from 1, or name. @throws UsageError
std::size_t find_case(const ExerciseReference& exercise, const std::string& asked);

/// The exercise that `review` would ask for today; "" if none is due.
std::string due_for_review(const Course& course, const Progress& progress);

/// What an update leaves to the reader to look at.
void print_update(const Release& now, const Release& before, const UpdateResult& result);

/// @throws std::runtime_error where no picture can be made, UsageError where none can be kept
void require_pictures(const fs::path& directory);

/// @throws UsageError where no page can be written
void require_page(const fs::path& file);

/// Copies the pictures of a lecture into a folder; returns how many figures they show. @throws fs::filesystem_error
std::size_t copy_figures(const Course& course, const std::string& lecture, const fs::path& to);

}  // namespace workbook
