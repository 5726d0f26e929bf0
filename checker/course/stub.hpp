/// @file
/// The exercise file as shipped. It follows from the card and the contract, so it can be made anew at any time.
#pragma once

#include "checker/course/course.hpp"

#include <filesystem>
#include <string>

namespace workbook {

/// An exercise's declaration in the contract, on one line and without the semicolon:
/// "Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r)". "" if the contract does not declare it.
std::string declared_signature(const Course& course, const Exercise& exercise);

/// The text of the stub: the task, the contract's header, the function with its TODO.
std::string stub_text(const CardExercise& entry, const std::string& contract, const std::string& signature);

/// Has the student begun, as far as can be seen without compiling: the file is there and no longer says "not started".
bool is_begun(const std::filesystem::path& file);

}  // namespace workbook
