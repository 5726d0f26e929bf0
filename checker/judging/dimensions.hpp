/// @file
/// Testing dimensions by a change of units: a quantity in kg m² grows 10⁴ times when lengths are given in centimetres.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/judging/answers.hpp"
#include "checker/judging/judgement.hpp"

#include <cstddef>
#include <vector>

namespace workbook {

/// The probes worth taking: for each base unit that an argument has, at up to three deciding cases. Their replies are
/// empty.
std::vector<UnitProbe> plan_probes(const ExerciseReference& exercise);

/// The inputs of a case with their numbers converted to the probe's small unit.
std::vector<Value> probe_inputs(const ExerciseReference& exercise, const UnitProbe& probe, std::size_t case_index);

/// One diagnosis for each base unit in which the student's result has a clearly wrong exponent; else one that says that
/// it has no single exponent; else none.
std::vector<Diagnosis> diagnose_dimensions(const ExerciseReference& exercise, const Answers& answers,
                                           const std::vector<UnitProbe>& probes);

}  // namespace workbook
