/// @file
/// Small made-up exercises and students, so that the judge is tested without any lecture.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"
#include "checker/judging/comparison.hpp"

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace workbook::testing {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

using Exercise = ExerciseReference;
using Inputs = std::vector<Value>;
using Function = std::function<Value(const Inputs&)>;

Value number(double value);
Value vector(const std::vector<double>& numbers);
/// A matrix of three rows, given row by row.
Value three_rows(const std::vector<std::vector<double>>& rows);
Value diagonal(double a, double b, double c);

/// What a function gives at all cases.
std::vector<Value> outputs(const Exercise& exercise, const Function& function);

/// Adds a case with the function's value as the expected one and its largest number as scale.
void add_case(Exercise& exercise, const std::string& name, const Inputs& inputs, const Function& right);
void add_misconception(Exercise& exercise, const std::string& name, const std::string& message, const Function& wrong);
void add_term(Exercise& exercise, const std::string& name, double coefficient, const Function& summand);
void add_property(Exercise& exercise, PropertyKind kind, const std::string& message);

/// The momentum m (u + 2 v) in kg m/s of vectors u, v in m/s: eight deciding cases and one at which all is zero.
/// Nothing is known yet of wrong answers.
Exercise momentum();
Value right_momentum(const Inputs& inputs);
/// Another factor of u and of v.
Function momentum_with(double of_u, double of_v);
/// momentum with misconceptions, terms, routes and a sweep: nothing is missing.
Exercise sound_momentum();

/// Adds a generated case that differs from another one in one argument.
void add_generated(Exercise& exercise, int base, int argument, const Value& input, const Function& right);

/// Results of any kind, given outright. Their only input is the number of the case.
Exercise given_results(Kind kind, const std::vector<Value>& expected, Comparison comparison = Comparison::plain);

/// The axes of one matrix.
Exercise eigenvectors(const Value& matrix, const Value& expected);
/// Two points with the rows (1, 0), (0, 1), (2, 2); half the sum of the first two squares is 1/2 in each.
Exercise conserved();

Reply returning(const Value& value);
Reply ending(Ending how, const std::string& text = "");
Observation observed(const std::vector<Value>& values);
Answers all_answers(const std::vector<Value>& values);

/// The file in which these results would be kept: the same for equal ones.
std::string as_written(const LectureReference& results);

/// The lines as one text.
std::string joined(const std::vector<std::string>& lines);

void compare_with_golden_file(const std::string& name, const std::string& text);

}  // namespace workbook::testing
