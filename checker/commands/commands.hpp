/// @file
/// What the program can be asked to do. Every command returns the exit status.
#pragma once

#include "checker/report/overlay.hpp"

namespace workbook {

enum ExitStatus { all_passed = 0, something_failed = 1, wrong_usage = 2, checker_failed = 3 };

/// The command was typed in a way that means nothing; the sentence says what to type.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the command line said; a command reads what it takes.
struct Options {
  std::vector<std::string> names;  ///< exercises and lectures; none: the whole course
  std::string name;                ///< one exercise or lecture; "": the command's own choice
  std::optional<std::filesystem::path> file;
  std::uint64_t seed = 1;  ///< that of the course, or another one
  bool is_seed_given = false;
  bool update = false;                   ///< the folder holds an earlier release
  std::string message;                   ///< what is new in a release
  std::optional<std::string> case_name;  ///< show this case in full, whether it passes or not
  bool started = false;                  ///< leave out what is not started
  bool full = false;                     ///< with all that the compiler says
  bool json = false;
  bool plot = false;
  bool all = false;                      ///< all hints, or all plots and figures
  std::vector<std::string> predictions;  ///< "4=0 0 1.5": a case and the numbers of the result
  std::string answer;                    ///< to the question on an exercise: "a", "b" or "c"; "": show the question
  bool build_only = false;               ///< the program for a debugger, without the debugger
  bool now = false;                      ///< the solution of an exercise that does not pass yet
  PictureKind picture = PictureKind::automatic;
  std::optional<std::filesystem::path> out;  ///< folder for pictures, results of a class, or a copy
  double seconds_per_figure = 60.0;
  std::filesystem::path html;
  std::string student;                ///< whose page it is; may be empty
  std::filesystem::path submissions;  ///< of a class: a folder or a zip file
  std::optional<std::filesystem::path> roster, assignment;
  std::vector<std::filesystem::path> references;  ///< reference results to judge by
  std::string only;                               ///< judge what has this verdict once more
  std::string shard;                              ///< "2/8": judge only this part of the class
  std::vector<std::filesystem::path> merged;      ///< folders of such parts, to be joined
  bool allow_reduced = false;                     ///< grade strangers' files in the reduced sandbox
};

/// Where the student stands, and what is next.
int status(const Course& course, const Options& options);

/// Every exercise with its state.
int list(const Course& course, const Options& options);

/// Grades exercises and explains what is wrong.
int check(const Course& course, const Options& options);

/// The next hint of an exercise, or all of them.
int hint(const Course& course, const Options& options);

/// The solution of an exercise that passes, and where its derivation is.
int solution(const Course& course, const Options& options);

/// Student's curves on the reference.
int plot(const Course& course, const Options& options);

/// The figures of a lecture, drawn with the student's own functions.
int figures(const Course& course, const Options& options);

/// The live figures of a lecture, computed with the student's own functions where they pass.
int live(const Course& course, const Options& options);

/// The worked examples of a lecture on the student's own functions: which of them hold.
int examples(const Course& course, const Options& options);

/// Builds a program of the student's with the own functions that it calls, and becomes it; without a file the first
/// time writes one.
int try_out(const Course& course, const Options& options);

/// Starts gdb at the first failing case of an exercise, or a given one.
int debug(const Course& course, const Options& options);

/// The case of that number, counted from 1, or name. @throws UnknownName
std::size_t find_case(const ExerciseReference& exercise, const std::string& asked);

/// Results that the student expects before there is a function: are they right, and which wrong functions would agree?
int predict(const Course& course, const Options& options);

/// A question on an exercise that passes: which mistake does another function make?
int question(const Course& course, const Options& options);

/// An exercise of some time ago, to be written once more.
int review(const Course& course, const Options& options);

/// One page with everything that the checker has to say to one student.
int report(const Course& course, const Options& options);

/// Puts the stub back; what was there is kept beside the progress file.
int reset(const Course& course, const Options& options);

/// Checks whatever is saved, until it is told to end.
int watch(const Course& course, const Options& options);

/// What this machine offers.
int doctor(const Course& course, const Options& options);

/// @throws std::runtime_error where no picture can be made
void require_pictures(const std::filesystem::path& directory);

/// Copies the pictures of a lecture into a folder; returns how many figures they show.
/// @throws std::filesystem::filesystem_error
std::size_t copy_figures(const Course& course, const std::string& lecture, const std::filesystem::path& to);

/// Writes the copy of the workbook that students get, or brings one to a new release: without solutions, with the
/// reference results of a seed as data.
int handout(const Course& course, const Options& options);

/// Brings this copy to the release of another one.
int update(const Course& course, const Options& options);

/// Grades a class, whose submissions come from strangers.
int grade(const Course& course, const Options& options);

/// Are these exercises and lectures in order, or the whole workbook? For authors.
/// @param seeds  in a copy without solutions its own is taken
int self_check(const Course& course, const std::vector<std::string>& names, std::vector<std::uint64_t> seeds);

/// Do the cases of these exercises find every small bug in their solutions? For authors.
int self_check_mutants(const Course& course, const std::vector<std::string>& names);

/// Writes the skeleton of a lecture: its card, contract, notes, worked examples and figures.
int new_lecture(const Course& course, const std::string& folder);

/// Writes the skeleton of an exercise that builds and is not started.
int new_exercise(const Course& course, const std::string& name, const std::string& lecture,
                 const std::string& signature);

}  // namespace workbook
