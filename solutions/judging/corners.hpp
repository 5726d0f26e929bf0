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

/// How far the result moves, in tolerances of the case, when every input is moved by four units in its last place. A
/// sound way through may lose that much and more. 0 where inputs or result are whole numbers.
double condition_of(const Case& one, const ExerciseReference& exercise,
                    const std::function<Value(const Values&)>& right);

/// Widens the tolerance where rounding of the inputs alone takes more than a sixteenth of it. False where so much would
/// have to be given that the case says nothing.
bool make_answerable(Case& one, const ExerciseReference& exercise, const std::function<Value(const Values&)>& right);

/// A few inputs of small whole numbers, the simplest first, that are legal and where all routes agree: the first case
/// that a student's answer fails can then be worked out by hand.
std::vector<Case> ladder(const Subject& subject);

/// Cases at zeros, equalities, extreme sizes, nearly unit directions, special angles, nearly equal numbers and parallel
/// vectors: those that are legal and where all routes agree with the reference.
std::vector<Case> corner_cases(const Subject& subject);

/// Right results for inputs with another sign, zero, transposed, exchanged, …, and results of the other functions that
/// can be called with the same arguments, where they differ from the right ones.
std::vector<InputTransform> input_transforms(const Subject& subject, const std::vector<Subject>& others);

/// A bug that can be made in any function of this signature: a threshold, a missing sign, float for double.
struct BugTemplate {
  std::string name;  ///< "|omega_2| below 0.001 taken for zero"
  std::function<Value(const Values&)> buggy;
};
std::vector<BugTemplate> bug_templates(const Subject& subject);

/// Tries every bug template at all cases, those described and these. A bug that passes them is looked for in a dense
/// sample of the domain; the name of the first point at which it shows is among the neighbours of the result.
Adequacy prove_adequacy(const Subject& subject, std::vector<Case> cases);

/// The points of the dense sample with these names, where cases can be made of them.
std::vector<Case> neighbour_cases(const Subject& subject, const std::vector<std::string>& names);

/// Of a record and of what it depends on: cases, their results to four digits, tolerances, names of the bugs. The same
/// on every machine.
std::string fingerprint_of(const Subject& subject, const Adequacy& record);

}  // namespace workbook::judging
