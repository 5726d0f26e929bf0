/// @file
/// Mistakes that compile, but can be read off the text of a file: 1/2, sin(30), x ^ 2.
#pragma once

#include "checker/data/observation.hpp"

#include <string>
#include <vector>

namespace workbook {

/// What is certainly so in this source, in the order of the lines.
std::vector<Finding> text_mistakes(const std::string& source);

}  // namespace workbook
