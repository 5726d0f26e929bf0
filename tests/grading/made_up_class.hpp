/// @file
/// A made-up class on the tiny course: right and wrong answers, and submissions that try to do harm.
#pragma once

#include "tests/program/program.hpp"

#include <map>

namespace workbook::testing {

/// A copy of the tiny course with the submissions of a class.
class MadeUpClass : public CourseCopy {
 public:
  std::filesystem::path submissions() const { return root() / "submissions"; }

  /// Hands in a file whose function has this body.
  void energy(const std::string& student, const std::string& body) const;
  void force(const std::string& student, const std::string& body) const;

  /// Twelve students with what students hand in, in every form.
  void hand_in_ordinary_files() const;
  /// Of a class that is judged in a few seconds.
  void hand_in_few_files() const;
  /// Submissions that are no files, or not what they seem.
  void hand_in_hostile_files() const;

  /// `checker grade submissions --out OUT --seed 1`, with more options; with the cases of single checks.
  Outcome grade(const std::string& out = "out", const std::string& options = "",
                const std::string& environment = "") const;

  /// The results of a student in out.
  nlohmann::json student(const std::string& id) const;
};

/// The body of a function that is right, or wrong for a reason.
extern const char *const right_energy, *const right_force, *const force_by_energy;

/// Root becomes another user to grade, who must reach this build.
bool is_open_to_all();

/// Does the journal hold every result once?
bool is_judged_once(const std::filesystem::path& journal);

/// All files of the results but the journal, with their content.
std::map<std::string, std::string> results_in(const std::filesystem::path& out);

}  // namespace workbook::testing
