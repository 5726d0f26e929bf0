/// @file
/// The inputs of a case as plain text, with every digit that it takes to try them out.
#pragma once

#include "checker/data/reference_results.hpp"
#include "checker/judging/text_blocks.hpp"

#include <string>
#include <vector>

namespace workbook {

/// "omega = (0.3, -0.2, 0.5) rad/s"; matrices and long lists in aligned columns below their name.
std::vector<std::string> input_lines(const Argument& argument, const Value& value, const Page& page = {});

}  // namespace workbook
