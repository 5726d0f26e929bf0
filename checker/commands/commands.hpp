/// @file
/// What the program can be asked to do. Every command returns the exit status.
#pragma once

#include "checker/course/course.hpp"
#include "checker/report/terminal_graphics.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace workbook {

enum ExitStatus { all_passed = 0, something_failed = 1, wrong_usage = 2, checker_failed = 3 };

struct CheckOptions {
  std::vector<std::string> names;  ///< exercises and lectures; none: the whole course
  std::optional<std::filesystem::path> file;
  std::uint64_t seed = 1;
  std::optional<std::string> case_name;  ///< show this case in full, whether it passes or not
  bool started = false;                  ///< leave out what is not started
  bool full = false;                     ///< with all that the compiler says
  bool json = false;
  bool plot = false;
  PictureKind picture = PictureKind::automatic;  ///< of the plot, on the terminal
};

struct PlotOptions {
  std::vector<std::string> names;
  bool all = false;
  std::optional<std::filesystem::path> file;
  std::optional<std::filesystem::path> out;
  std::uint64_t seed = 1;
  PictureKind picture = PictureKind::automatic;
};

struct FiguresOptions {
  std::string lecture;
  std::optional<std::filesystem::path> out;
  double seconds_per_figure = 60.0;
};

struct ReportOptions {
  std::filesystem::path html;
  std::vector<std::string> names;  ///< exercises and lectures; none: the whole course
  std::optional<std::filesystem::path> file;
  std::uint64_t seed = 1;
  std::string student;  ///< whose page it is; may be empty
};

/// Where the student stands, and what is next.
int status(const Course& course);

/// Every exercise with its state.
int list(const Course& course);

int check(const Course& course, const CheckOptions& options);

/// The next hint of an exercise, or all of them.
int hint(const Course& course, const std::string& name, bool all);

int plot(const Course& course, const PlotOptions& options);

/// The figures of a lecture, drawn with the student's own functions.
int figures(const Course& course, const FiguresOptions& options);

/// One page with everything that the checker has to say to one student.
int report(const Course& course, const ReportOptions& options);

/// Puts the stub back; what was there is kept beside the progress file.
int reset(const Course& course, const std::string& name);

/// Checks whatever is saved, until it is told to end.
/// @param course_file  what the course was read from
/// @param name         where to begin, an exercise or a lecture; "": the next exercise that does not pass
int watch(const Course& course, const std::filesystem::path& course_file, const std::string& name);

/// The worked examples of a lecture on the student's own functions: which of them come out by now.
int examples(const Course& course, const std::string& lecture);

/// Writes the copy of the workbook that students get: without solutions, with the reference results as data.
int handout(const Course& course, const std::filesystem::path& directory);

/// What this machine offers.
int doctor(const Course& course);

/// Is the workbook itself in order? For authors.
int self_check(const Course& course, const std::vector<std::uint64_t>& seeds);

}  // namespace workbook
