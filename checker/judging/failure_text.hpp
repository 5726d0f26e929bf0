/// @file
/// The first failing case in full, as plain text.
#pragma once

#include "checker/data/reference_results.hpp"
#include "checker/judging/judgement.hpp"
#include "checker/judging/text_blocks.hpp"

#include <string>
#include <vector>

namespace workbook {

/// Inputs, expected, yours and their difference, lined up number by number, with units, and the size of the error in
/// words. On a page too narrow for columns, or a linear one, number by number below each other. Empty if no case
/// failed.
std::vector<std::string> describe_failure(const ExerciseReference& exercise, const Judgement& judgement,
                                          const Page& page = {});

}  // namespace workbook
