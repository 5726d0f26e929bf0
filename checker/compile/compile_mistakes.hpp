/// @file
/// The mistakes that compilers complain about, by name.
#pragma once

#include "checker/compile/diagnostics.hpp"
#include "checker/data/observation.hpp"

#include <optional>
#include <string>
#include <vector>

namespace workbook {

/// The first error of a compilation: the student's line with a caret, and what is wrong there. Where several errors
/// concern that line, the one that is understood best. Nothing if no error has a place in the file.
///
/// @param found      what the compiler said
/// @param source     the student's file
/// @param signature  of the exercise, as the contract declares it: "double twice(double x)"
std::optional<Finding> first_error(const std::vector<Diagnostic>& found, const std::string& source,
                                   const std::string& signature);

/// What is to be said of an error without a place.
std::string error_text(const Diagnostic& error);

}  // namespace workbook
