/// @file
/// Recognising a named wrong answer.
#pragma once

#include "checker/judging/answers.hpp"
#include "checker/judging/judgement.hpp"

#include <optional>

namespace workbook {

/// The misconception that gives the student's answers at all deciding cases; none if two with different messages fit,
/// or if the student is not wrong at any of them.
std::optional<Diagnosis> diagnose_misconception(const ExerciseReference& exercise, const Answers& answers);

}  // namespace workbook
