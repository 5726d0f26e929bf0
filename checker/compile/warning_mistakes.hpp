/// @file
/// Mistakes that compile, but that the compiler warns of.
#pragma once

#include "checker/compile/diagnostics.hpp"
#include "checker/data/observation.hpp"

#include <string>
#include <vector>

namespace workbook {

/// The flags that ask for the warnings that warning_mistakes() understands.
const std::vector<std::string>& warning_flags();

/// What is certainly so, in the compiler's order; what is merely odd comes last.
std::vector<Finding> warning_mistakes(const std::vector<Diagnostic>& found, const std::string& source);

}  // namespace workbook
