/// @file
/// What a class has handed in: whatever lies there, only files with the names of exercises are read, each for one
/// student, and copied to fixed names.
#pragma once

#include "checker/grading/assignment.hpp"

namespace workbook {

/// What was found for one exercise.
struct HandedIn {
  bool is_in_place = false;  ///< it lies where the workbook has it: other files of that name don't count
  std::string where;         ///< in the submissions, as it may be shown
  std::string refusal;       ///< one sentence; "": it was copied
};

struct Student {
  std::string id;    ///< as it may be shown
  std::string name;  ///< of the roster; may be empty
  std::string slug;  ///< names this student's files: letters, digits, "-", "_" and "."
  std::optional<std::int64_t> submitted;
  std::map<std::string, HandedIn> files;  ///< by exercise
  /// By exercise, as the progress file says that was handed in; nothing: there is none that can be read.
  std::optional<std::map<std::string, std::size_t>> hints;
  std::vector<std::string> notes;  ///< what else is to be said of the submission
};

struct Intake {
  std::vector<Student> students;
  std::vector<std::string> problems;  ///< what belongs to no student
};

/// Which students are taken in: those of one of several equal parts of the class, which any machine tells by their ids.
struct Shard {
  std::uint64_t number = 1, count = 1;

  bool has(const std::string& id) const;
};

/// "2/8". @throws GradingError
Shard read_shard(const std::string& text);

/// Takes in a folder per student, files called ID_EXERCISE.cpp, and zip files of both.
/// @param copies  DIR/SLUG/EXERCISE.cpp is written there. @throws GradingError, std::runtime_error
Intake take_in(const fs::path& submissions, const Course& course, const std::vector<RosterEntry>& roster,
               const fs::path& copies, const Shard& shard = {});

/// One file of a zip file.
struct Zipped {
  std::string path;
  std::string text;
  std::string refusal;  ///< one sentence; "": here is its text
};

/// Reads, in a process of its own and in a sandbox, the files with these names; what is zipped once more as well.
/// @throws RejectedFile
std::vector<Zipped> read_zip(const fs::path& file, const std::vector<std::string>& names);

}  // namespace workbook
