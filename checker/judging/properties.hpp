/// @file
/// Properties that every right result has, and where a result lacks one.
#pragma once

#include "checker/judging/answers.hpp"
#include "checker/judging/judgement.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace workbook {

/// How far a value is from having a property.
struct Violation {
  double size = 0.0;   ///< relative to the natural size of the result; 0 if the value has the property
  std::string detail;  ///< where it shows: "entry (1,2) is 3, entry (2,1) is -3"
};

Violation violation(const ExerciseReference& exercise, const Property& property, std::size_t case_index,
                    const Value& value);

/// True if the value lacks the property by clearly more than the tolerance of its case.
bool clearly_lacks(const ExerciseReference& exercise, const Property& property, std::size_t case_index,
                   const Value& value);

/// One diagnosis for each property that all expected values have and a student's value at some deciding case clearly
/// lacks.
std::vector<Diagnosis> diagnose_properties(const ExerciseReference& exercise, const Answers& answers);

}  // namespace workbook
