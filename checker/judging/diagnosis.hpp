/// @file
/// Why an answer is wrong: the most telling of the diagnoses.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/judging/answers.hpp"
#include "checker/judging/judgement.hpp"

#include <vector>

namespace workbook {

/// A misconception that gives the student's answers explains them wholly, and so does a wrong coefficient or a
/// transform of the whole: then it stands alone. Otherwise: what properties and dimensions tell. Empty where nothing
/// certain can be said.
std::vector<Diagnosis> diagnose(const ExerciseReference& exercise, const Answers& answers,
                                const std::vector<UnitProbe>& probes);

}  // namespace workbook
