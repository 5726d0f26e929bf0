/// @file
/// A command as data: its help, what it takes, and what it does. Each stands beside its code.
#pragma once

#include "checker/course/course.hpp"

#include <functional>
#include <variant>

namespace workbook {

enum ExitStatus { all_passed = 0, something_failed = 1, wrong_usage = 2, checker_failed = 3 };

inline constexpr const char *students = "For students", *instructors = "For instructors", *authors = "For authors";

/// Where what was typed goes; a bool is a flag.
using Target =
    std::variant<bool*, int*, double*, std::string*, fs::path*, std::vector<std::string>*, std::vector<fs::path>*,
                 std::optional<std::string>*, std::optional<fs::path>*, std::optional<std::uint64_t>*>;

/// Refuses what the command could not use, before anything is built for it. @throws UsageError
using Requirement = std::function<void(const Course& course)>;

struct Parameter {
  const char* name;  ///< "--seed", or "EXERCISE" where it has no name
  const char* type;  ///< of what is typed, for the help: "NUMBER"
  Target target;
  std::string help;
  bool is_required = false;
  Requirement require = {};        ///< if it was typed
  std::pair<int, int> range = {};  ///< of a number; none: any
  const char* excludes = "";       ///< the parameter that may not stand beside it
};

struct Command {
  std::string name;  ///< "check"; "new lecture" is a part of "new"
  const char* group;
  std::string help;  ///< its first line stands in the list of commands, the rest below the parameters
  std::vector<std::string> examples;
  std::vector<Parameter> parameters;
  std::function<int(const Course& course)> run;  ///< returns the exit status
  Requirement require = {};
};

// In the order of their groups in the help, each made in the file of its name; the last in program/on_demand_commands.cpp.
Command check_command(), watch_command(), list_command(), hint_command(), solution_command(), plot_command(),
    reset_command(), predict_command(), question_command(), review_command(), exam_command(), update_command(),
    prepare_command(), doctor_command();
Command report_command(), figures_command(), live_command(), examples_command(), try_command(), debug_command(),
    handout_command(), grade_command(), export_command(), self_check_command(), new_lecture_command(),
    new_exercise_command();

/// Without a command.
int status(const Course& course);

// --- parameters of several commands. The targets live as long as the command

Parameter names_parameter(std::vector<std::string>& names);
Parameter name_parameter(std::string& name);
Parameter exercise_parameter(std::string& name, const char* help = "its name", bool is_required = true);
Parameter lecture_parameter(std::string& name);
/// @param is_for_a_program  where it points to true, what is wrong with the file becomes a verdict
Parameter own_file_parameter(std::optional<fs::path>& file, const bool* is_for_a_program = nullptr);
Parameter seed_parameter(std::optional<std::uint64_t>& seed);
/// Where something is to be written.
Parameter place_parameter(const char* name, const char* type, std::optional<fs::path>& place, const char* help,
                          bool is_required = false);

/// @throws UsageError saying what is meant, where there is no such file
void require_file(const fs::path& file, const char* what);

/// Every exercise that is named, or all; refused while it is a problem of an exam. @throws UsageError
Requirement no_help_in_exam(const std::vector<std::string>& names);
Requirement no_help_in_exam(const std::string& name);

/// A command whose run gets its own options.
template <class Options>
std::function<int(const Course&)> with_options(const std::shared_ptr<Options>& options,
                                               int (*code)(const Course&, const Options&)) {
  return [options, code](const Course& course) { return code(course, *options); };
}

}  // namespace workbook
