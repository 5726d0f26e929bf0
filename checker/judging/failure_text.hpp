/// @file
/// The first failing case in full, as plain text for a terminal of 80 columns.
#pragma once

#include "checker/data/reference_results.hpp"
#include "checker/judging/judgement.hpp"

#include <string>
#include <vector>

namespace workbook {

/// Inputs, expected, yours and their difference, lined up number by number, with units, and the size of the error in
/// words. Empty if no case failed.
std::vector<std::string> describe_failure(const ExerciseReference& exercise, const Judgement& judgement);

}  // namespace workbook
