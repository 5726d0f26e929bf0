/// @file
/// Recognising an answer that is the right one, changed as a whole.
#pragma once

#include "checker/judging/answers.hpp"
#include "checker/judging/judgement.hpp"

#include <optional>

namespace workbook {

/// A common factor (−1, 2, ½, degrees for radians, or any other), a transposed matrix, or components in another order:
/// named if it gives the student's answers at all deciding cases.
std::optional<Diagnosis> diagnose_transform(const ExerciseReference& exercise, const Answers& answers);

}  // namespace workbook
