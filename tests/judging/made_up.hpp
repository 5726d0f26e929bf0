/// @file
/// Small made-up exercises and students, so that the judge is tested without any lecture.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"
#include "checker/judging/answers.hpp"
#include "checker/judging/judgement.hpp"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace workbook::testing {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

Value number(double value);
Value vector(std::vector<double> numbers);

/// A matrix of three rows, given row by row.
Value three_rows(std::vector<std::vector<double>> rows);

using Inputs = std::vector<Value>;
using Function = std::function<Value(const Inputs&)>;

/// What a function gives at all cases.
std::vector<Value> outputs(const ExerciseReference& exercise, const Function& function);

/// Adds a case with the function's value as the expected one and its largest number as scale.
void add_case(ExerciseReference& exercise, std::string name, Inputs inputs, const Function& right);

void add_misconception(ExerciseReference& exercise, std::string name, std::string message, const Function& wrong);
void add_term(ExerciseReference& exercise, std::string name, double coefficient, const Function& summand);
void add_property(ExerciseReference& exercise, PropertyKind kind, std::string message);

/// The momentum m (u + 2 v) in kg m/s of vectors u, v in m/s: eight deciding cases and one at which all is zero.
/// Nothing is known yet of wrong answers.
ExerciseReference momentum();
Value right_momentum(const Inputs& inputs);

/// Another factor of u and of v.
Function momentum_with(double of_u, double of_v);

/// momentum with misconceptions, terms, routes and a sweep: nothing is missing.
ExerciseReference sound_momentum();

/// Results of any kind, given outright. Their only input is the number of the case.
ExerciseReference given_results(Kind kind, std::vector<Value> expected);

Reply returning(Value value);
Reply ending(Ending how, std::string text = "");

/// A student whose function gives these values.
Observation observed(const std::vector<Value>& values);

Answers all_answers(const std::vector<Value>& values);

bool contains(const std::string& text, const std::string& part);

/// The lines as one text.
std::string joined(const std::vector<std::string>& lines);

}  // namespace workbook::testing
