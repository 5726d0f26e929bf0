/// @file
/// The texts that belong to an exercise: its hints, its place in the notes, its stub.
#pragma once

#include "checker/course/course.hpp"

namespace workbook {

/// The hints of a file, weakest first, which are separated by lines of three dashes.
/// @throws CourseError if it is missing or holds none.
std::vector<std::string> read_hints(const fs::path& file);

/// The headings of a lecture's notes by their anchors: "steiner" → "The theorem of Steiner". Empty if the file cannot
/// be read: a heading is a help, and the anchor does as well.
std::map<std::string, std::string> read_headings(const fs::path& notes);

/// The title of the lecture's first worked example that calls the function; "" if none does.
std::string example_that_calls(const Course& course, const Exercise& exercise);

/// An exercise's declaration in the contract, on one line and without the semicolon:
/// "Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r)". "" if the contract does not declare it.
std::string declared_signature(const Course& course, const Exercise& exercise);

/// The text of the stub: where the task is to be read, so that a correction of it never touches a student's file; the
/// contract's header, the function with its TODO.
std::string stub_text(const Exercise& exercise, const std::string& signature);

/// Has the student begun, as far as can be seen without compiling: the file is there and no longer says "not started".
bool is_begun(const fs::path& file);

}  // namespace workbook
