/// @file
/// Runs the checker as a program on a copy of the tiny course, as a student would.
#pragma once

#include "tests/support/files.hpp"

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

namespace workbook::testing {

struct TerminalOutcome {
  int status = -1;
  std::string shown;  ///< standard output and standard error, as the terminal got them
};

/// A copy of the tiny course in a folder of its own, gone at the end of the test.
class CourseCopy {
 public:
  CourseCopy();
  ~CourseCopy();
  CourseCopy(const CourseCopy&) = delete;
  CourseCopy& operator=(const CourseCopy&) = delete;

  /// Runs `checker ARGUMENTS`, quoted as for a shell; `environment` stands before it ("NO_COLOR=1").
  Outcome run(const std::string& arguments, const std::string& environment = "") const;

  /// Starts the same on a terminal of its own, with an environment that holds nothing else but PATH.
  /// @param prepare  done in the new process before. Returns the process and our end of its terminal.
  std::pair<pid_t, int> start_on_terminal(const std::string& arguments, int columns, int rows,
                                          const std::string& environment, const std::function<void()>& prepare) const;
  /// Waits until it has ended.
  TerminalOutcome run_on_terminal(const std::string& arguments, int columns, int rows,
                                  const std::string& environment) const;

  /// Commands with what they print and how they end, for a golden file.
  std::string screens(const std::vector<std::string>& commands, const std::string& environment = "COLUMNS=80") const;

  /// Types what follows each "$ " of tests/program/golden/NAME.txt into a shell, in which `checker` is ours, and
  /// compares all screens with that file. Returns the screens.
  std::string check_story(const std::string& name, const std::string& environment = "COLUMNS=80") const;

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path exercise(const std::string& name) const {
    return root_ / "lectures/01_springs/exercises" / (name + ".cpp");
  }
  std::filesystem::path solution(const std::string& name) const {
    return root_ / "solutions/01_springs" / (name + ".cpp");
  }
  std::filesystem::path reference() const { return root_ / "reference/01_springs.json"; }
  std::filesystem::path card() const { return root_ / "lectures/01_springs/card.json"; }
  std::filesystem::path notes() const { return root_ / "lectures/01_springs/notes.md"; }

  /// Writes an answer to spring_energy with this body.
  void answer_energy(const std::string& body, const std::string& before = "") const;
  /// Puts the solution in place of the student's file.
  void solve(const std::string& name) const;
  /// A shell script in place of a program of the build, or of checker/setup.sh, which makes them: setup.sh.
  void stand_in(const std::string& program, const std::string& script) const;

 private:
  std::string shell_command(const std::string& arguments, const std::string& environment) const;
  std::string shown_after(const std::string& typed, const std::string& environment) const;
  std::string without_place(std::string text) const;

  std::filesystem::path root_;
};

/// The text of a file with a function that has this body, from line 4 on.
std::string energy_text(const std::string& body);
std::string force_text(const std::string& body);

inline const std::string without_programs = "PATH=/nowhere";

/// Compares with tests/program/golden/NAME.txt, as a whole; see tests/support/golden.hpp.
void check_golden(const std::string& name, const std::string& text);

}  // namespace workbook::testing
