/// @file
/// The judge: from what was seen of a student's function to what the checker says of it.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"
#include "checker/judging/judgement.hpp"

namespace workbook {

/// A pure function: the same observation always gets the same judgement. Only values that were compared here can pass;
/// everything that is missing or odd fails.
Judgement judge(const ExerciseReference& exercise, const Observation& observation);

}  // namespace workbook
