/// @file
/// What follows from a signature, its units and its domain without anything being said of the exercise: cases in the
/// corners of the domain, right results for changed inputs, and a proof that typical bugs are found.
#pragma once

#include "checker/data/reference_results.hpp"

#include <functional>
#include <string>
#include <vector>

namespace workbook::judging {

using Values = std::vector<Value>;

/// An exercise with its functions, without their types.
struct Subject {
  const ExerciseReference& described;  ///< with the cases that its author gave
  std::function<Value(const Values&)> right;
  std::vector<std::function<Value(const Values&)>> routes;
  std::function<bool(const Values&)> legal;
  /// A generated case with this name and these inputs: expected value, scale, tolerance. @throws if it cannot be one
  std::function<Case(Case)> judged;
};

/// A few inputs of small whole numbers, the simplest first, that are legal and where all routes agree: the first case
/// that a student's answer fails can then be worked out by hand.
std::vector<Case> ladder(const Subject& subject);

/// Cases at zeros, equalities, extreme sizes, nearly unit directions, special angles, nearly equal numbers and parallel
/// vectors: those that are legal and where all routes agree with the reference.
std::vector<Case> corner_cases(const Subject& subject);

/// Right results for inputs with another sign, zero, transposed, exchanged, … that differ from the right ones.
std::vector<InputTransform> input_transforms(const Subject& subject);

/// A bug that can be made in any function of this signature: a threshold, a missing sign, float for double.
struct BugTemplate {
  std::string name;  ///< "|omega_2| below 0.001 taken for zero"
  std::function<Value(const Values&)> buggy;
};
std::vector<BugTemplate> bug_templates(const Subject& subject);

/// Tries every bug template at all cases. A bug that passes them is looked for in a dense sample of the domain; where
/// it shows, that point becomes a case.
void prove_adequacy(const Subject& subject, std::vector<Case>& cases, Adequacy& adequacy);

}  // namespace workbook::judging
