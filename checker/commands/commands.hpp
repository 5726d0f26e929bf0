/// @file
/// What the program can be asked to do. Every command returns the exit status.
#pragma once

#include "checker/course/course.hpp"
#include "checker/report/terminal_picture.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

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
  std::uint64_t seed = 1;
  std::optional<std::string> case_name;  ///< show this case in full, whether it passes or not
  bool started = false;                  ///< leave out what is not started
  bool full = false;                     ///< with all that the compiler says
  bool json = false;
  bool plot = false;
  bool all = false;  ///< all hints, or all plots and figures
  bool now = false;  ///< the solution of an exercise that does not pass yet
  PictureKind picture = PictureKind::automatic;
  std::optional<std::filesystem::path> out;  ///< folder for pictures
  double seconds_per_figure = 60.0;
  std::filesystem::path html;
  std::string student;  ///< whose page it is; may be empty
};

/// Where the student stands, and what is next.
int status(const Course& course);

/// Every exercise with its state.
int list(const Course& course);

/// What is to be checked. @throws UnknownName, and UsageError where --file or --case is given for several exercises
std::vector<CheckTask> tasks_of(const Course& course, const Options& options);

int check(const Course& course, const Options& options);

/// The next hint of an exercise, or all of them.
int hint(const Course& course, const Options& options);

/// The solution of an exercise that passes, and where its derivation is.
int solution(const Course& course, const Options& options);

/// Student's curves on the reference.
int plot(const Course& course, const Options& options);

/// The figures of a lecture, drawn with the student's own functions.
int figures(const Course& course, const Options& options);

/// The worked examples of a lecture on the student's own functions: which of them hold.
int examples(const Course& course, const Options& options);

/// One page with everything that the checker has to say to one student.
int report(const Course& course, const Options& options);

/// Puts the stub back; what was there is kept beside the progress file.
int reset(const Course& course, const std::string& name);

/// Checks whatever is saved, until it is told to end.
/// @param course_file  what the course was read from
/// @param name         where to begin, an exercise or a lecture; "": the next exercise that does not pass
int watch(const Course& course, const std::filesystem::path& course_file, const std::string& name);

/// Writes the copy of the workbook that students get: without solutions, with the reference results as data.
int handout(const Course& course, const std::filesystem::path& directory);

/// What this machine offers.
int doctor(const Course& course);

/// Are these exercises and lectures in order, or the whole workbook? For authors.
int self_check(const Course& course, const std::vector<std::string>& names, const std::vector<std::uint64_t>& seeds);

/// Writes the skeleton of a lecture: its card, contract, notes, worked examples and figures.
int new_lecture(const Course& course, const std::string& folder);

/// Writes the skeleton of an exercise that builds and is not started.
int new_exercise(const Course& course, const std::string& name, const std::string& lecture,
                 const std::string& signature);

}  // namespace workbook
