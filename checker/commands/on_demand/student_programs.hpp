/// @file
/// Programs that call the student's functions.
#pragma once

#include "checker/commands/on_demand/options.hpp"

namespace workbook {

/// What the student's functions are called by.
struct Caller {
  std::string target;              ///< the program
  fs::path source;                 ///< its text names the functions
  std::vector<std::string> parts;  ///< targets that it is linked from, besides the student's objects
  std::string what;                ///< in words
};

/// Builds a program on the student's functions and returns its path. Where files of the student cannot be used, names
/// them and returns "". @throws std::runtime_error if it cannot be built for another reason
std::string student_program(const Course& course, const Caller& caller);

/// What became of a worked example or a figure.
struct Outcome {
  std::string trouble;  ///< empty: none
  bool is_not_started = false;
};

void print_outcome(const std::string& name, const Outcome& outcome);

/// Compiles a program with the student's files that it may call. Where it does not compile, prints what the compiler
/// says and returns false. @throws std::runtime_error
bool build_program(const Course& course, const fs::path& source, const std::vector<Submission>& files,
                   const std::vector<std::string>& options, const fs::path& program);

/// A folder of this command, new and empty. @throws std::runtime_error
fs::path folder_of(const Course& course, const char* command);

/// @throws std::runtime_error where it is missing
std::string path_of_gdb();

/// Builds the program of one case of the student's file, without optimisation, and names the case. Returns its path;
/// "" where it does not compile, which it says.
fs::path case_program(const Course& course, CheckContext& context, const CheckTask& task, std::size_t index);

/// The words that start it, with our printers of vectors and matrices.
std::vector<std::string> debugger(const CheckContext& context, const std::string& gdb);

}  // namespace workbook
