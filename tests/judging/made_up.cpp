#include "tests/judging/made_up.hpp"

#include "tests/support/files.hpp"
#include "tests/support/golden.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace workbook::testing {

Value number(double value) { return {1, 1, {value}}; }
Value vector(const std::vector<double>& numbers) { return {static_cast<int>(numbers.size()), 1, numbers}; }
Value diagonal(double a, double b, double c) { return three_rows({{a, 0, 0}, {0, b, 0}, {0, 0, c}}); }

Value three_rows(const std::vector<std::vector<double>>& rows) {
  Value value{3, static_cast<int>(rows.at(0).size()), {}};
  for (std::size_t col = 0; col < rows[0].size(); ++col)
    for (const auto& row : rows) value.numbers.push_back(row.at(col));
  return value;
}

std::vector<Value> outputs(const Exercise& exercise, const Function& function) {
  std::vector<Value> values;
  values.reserve(exercise.cases.size());
  for (const Case& one : exercise.cases) values.push_back(function(one.inputs));
  return values;
}

void add_case(Exercise& exercise, const std::string& name, const Inputs& inputs, const Function& right) {
  const Value expected = right(inputs);
  double largest = 0.0;
  for (double entry : expected.numbers) largest = std::max(largest, std::abs(entry));
  exercise.cases.push_back({name, Group::random, true, inputs, expected, {largest > 0 ? largest : 1.0}});
}

void add_misconception(Exercise& exercise, const std::string& name, const std::string& message, const Function& wrong) {
  exercise.misconceptions.push_back({name, message, "made_up_anchor", outputs(exercise, wrong), {}});
}

void add_term(Exercise& exercise, const std::string& name, double coefficient, const Function& summand) {
  exercise.terms.push_back({name, coefficient, outputs(exercise, summand)});
}

void add_property(Exercise& exercise, PropertyKind kind, const std::string& message) {
  exercise.properties.push_back({kind, message, "made_up_anchor", -1, {}});
}

Function momentum_with(double of_u, double of_v) {
  return [=](const Inputs& inputs) {
    Value result = inputs[1];
    for (std::size_t n = 0; n < 3; ++n)
      result.numbers[n] = inputs[0].numbers[0] * (of_u * inputs[1].numbers[n] + of_v * inputs[2].numbers[n]);
    return result;
  };
}

Value right_momentum(const Inputs& inputs) { return momentum_with(1, 2)(inputs); }

Exercise momentum() {
  Exercise exercise = given_results(Kind::vector3, {});
  exercise.name = "momentum";
  exercise.signature = "Vector3d momentum(double m, const Vector3d& u, const Vector3d& v)";
  exercise.arguments = {{"m", Kind::number, units::kilogram},
                        {"u", Kind::vector3, units::metre_per_second},
                        {"v", Kind::vector3, units::metre_per_second}};
  exercise.result_name = "p";
  exercise.result_units = {units::kilogram * units::metre_per_second};

  add_case(exercise, "the worked one", {number(2), vector({1, 2, 3}), vector({0.5, -1, 4})}, right_momentum);
  exercise.cases.front().group = Group::worked;
  for (int k = 1; k <= 7; ++k) {
    const Inputs inputs = {number(1 + 0.3 * k), vector({std::sin(k), std::cos(2 * k), std::sin(5 * k)}),
                           vector({std::cos(k), std::sin(3 * k), std::cos(7 * k)})};
    add_case(exercise, fmt::format("generic {}", k), inputs, right_momentum);
  }
  add_case(exercise, "at rest", {number(2), vector({0, 0, 0}), vector({0, 0, 0})}, right_momentum);
  exercise.cases.back().group = Group::special;
  exercise.cases.back().deciding = false;
  return exercise;
}

Exercise sound_momentum() {
  Exercise exercise = momentum();
  add_misconception(exercise, "no_two", "The velocity v enters twice, not once.", momentum_with(1, 1));
  add_misconception(exercise, "minus", "The two velocities add up.", momentum_with(1, -2));
  add_misconception(exercise, "exchanged", "You exchange u and v.", momentum_with(2, 1));
  add_term(exercise, "m u", 1, momentum_with(1, 0));
  add_term(exercise, "m v", 2, momentum_with(0, 1));
  exercise.routes = {{"as it stands", outputs(exercise, right_momentum)},
                     {"with rounding errors", outputs(exercise, momentum_with(1 + 1e-14, 2 - 1e-14))},
                     {"with others", outputs(exercise, momentum_with(1 - 2e-14, 2 + 1e-14))}};

  exercise.sweep = {"momentum over mass", "m (kg)", "p (kg m/s)", {}, {}, {}, {{"p_x", 0, 0}}};
  for (std::size_t i : {0, 1}) {
    exercise.sweep.x.push_back(static_cast<double>(i));
    exercise.sweep.inputs.push_back(exercise.cases[i].inputs);
    exercise.sweep.expected.push_back(exercise.cases[i].expected);
    for (Misconception& wrong : exercise.misconceptions) wrong.sweep_outputs.push_back(wrong.outputs[i]);
  }
  return exercise;
}

void add_generated(Exercise& exercise, int base, int argument, const Value& input, const Function& right) {
  Inputs inputs = exercise.cases.at(static_cast<std::size_t>(base)).inputs;
  inputs.at(static_cast<std::size_t>(argument)) = input;
  add_case(exercise, fmt::format("generated {}", exercise.cases.size()), inputs, right);
  Case& one = exercise.cases.back();
  one.group = Group::generated;
  one.deciding = false;
  one.base = base;
  one.argument = argument;
}

Exercise given_results(Kind kind, const std::vector<Value>& expected, Comparison comparison) {
  Exercise exercise;
  exercise.name = "given";
  exercise.signature = "Anything given(int k)";
  exercise.arguments = {{"k", Kind::integer, units::none}};
  exercise.result_kind = kind;
  exercise.result_name = "y";
  exercise.result_units = {units::none};
  exercise.comparison = comparison;
  for (const Value& value : expected) {
    const std::size_t k = exercise.cases.size();
    add_case(exercise, fmt::format("number {}", k), {number(static_cast<double>(k))}, [&](auto&) { return value; });
  }
  return exercise;
}

Exercise eigenvectors(const Value& matrix, const Value& expected) {
  Exercise exercise = given_results(Kind::matrix3, {expected}, Comparison::eigenvectors);
  exercise.arguments = {{"I", Kind::matrix3, units::moment_of_inertia}};
  exercise.cases[0].inputs = {matrix};
  return exercise;
}

Exercise conserved() {
  Exercise exercise = given_results(Kind::points, {three_rows({{1, 0}, {0, 1}, {2, 2}})});
  exercise.properties = {
      {PropertyKind::constant_weighted_square, "The energy ½ Σ v² stays the same.", "energy", -1, {{0.5, 0.5, 0}}}};
  exercise.cases[0].tolerance = 1e-3;
  return exercise;
}

Reply returning(const Value& value) { return {Ending::returned, value}; }
Reply ending(Ending how, const std::string& text) { return {how, {}, text}; }

Observation observed(const std::vector<Value>& values) {
  Observation observation;
  for (const Value& value : values) observation.replies.push_back(returning(value));
  return observation;
}

Answers all_answers(const std::vector<Value>& values) { return {values.begin(), values.end()}; }

std::string as_written(const LectureReference& results) {
  const std::filesystem::path file = std::filesystem::path(WORKBOOK_TEST_SCRATCH) / "written.json";
  write_reference_results(results, file);
  return read(file);
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

void compare_with_golden_file(const std::string& name, const std::string& text) {
  compare_with_golden(std::filesystem::path(WORKBOOK_TEST_GOLDEN) / name, text);
}

}  // namespace workbook::testing
