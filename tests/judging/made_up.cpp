#include "tests/judging/made_up.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace workbook::testing {

Value number(double value) { return {1, 1, {value}}; }

Value vector(std::vector<double> numbers) {
  const int rows = static_cast<int>(numbers.size());
  return {rows, 1, std::move(numbers)};
}

Value three_rows(std::vector<std::vector<double>> rows) {
  Value value{3, static_cast<int>(rows.at(0).size()), {}};
  for (std::size_t col = 0; col < rows[0].size(); ++col) {
    for (const auto& row : rows) value.numbers.push_back(row.at(col));
  }
  return value;
}

std::vector<Value> outputs(const ExerciseReference& exercise, const Function& function) {
  std::vector<Value> values;
  for (const Case& one : exercise.cases) values.push_back(function(one.inputs));
  return values;
}

void add_case(ExerciseReference& exercise, std::string name, Inputs inputs, const Function& right) {
  Case one;
  one.name = std::move(name);
  one.expected = right(inputs);
  one.inputs = std::move(inputs);
  double largest = 0.0;
  for (double entry : one.expected.numbers) largest = std::max(largest, std::abs(entry));
  one.scale = {largest > 0 ? largest : 1.0};
  exercise.cases.push_back(std::move(one));
}

void add_misconception(ExerciseReference& exercise, std::string name, std::string message, const Function& wrong) {
  exercise.misconceptions.push_back(
      {std::move(name), std::move(message), "made_up_anchor", outputs(exercise, wrong), {}});
}

void add_term(ExerciseReference& exercise, std::string name, double coefficient, const Function& summand) {
  exercise.terms.push_back({std::move(name), coefficient, outputs(exercise, summand)});
}

void add_property(ExerciseReference& exercise, PropertyKind kind, std::string message) {
  exercise.properties.push_back({kind, std::move(message), "made_up_anchor", -1, {}});
}

Function momentum_with(double of_u, double of_v) {
  return [=](const Inputs& inputs) {
    Value result = inputs[1];
    for (std::size_t n = 0; n < 3; ++n) {
      result.numbers[n] = inputs[0].numbers[0] * (of_u * inputs[1].numbers[n] + of_v * inputs[2].numbers[n]);
    }
    return result;
  };
}

Value right_momentum(const Inputs& inputs) { return momentum_with(1, 2)(inputs); }

ExerciseReference momentum() {
  ExerciseReference exercise;
  exercise.name = "momentum";
  exercise.signature = "Vector3d momentum(double m, const Vector3d& u, const Vector3d& v)";
  exercise.arguments = {{"m", Kind::number, units::kilogram},
                        {"u", Kind::vector3, units::metre_per_second},
                        {"v", Kind::vector3, units::metre_per_second}};
  exercise.result_kind = Kind::vector3;
  exercise.result_name = "p";
  exercise.result_units = {units::kilogram * units::metre_per_second};

  add_case(exercise, "the worked one", {number(2), vector({1, 2, 3}), vector({0.5, -1, 4})}, right_momentum);
  exercise.cases.front().group = Group::worked;
  for (int k = 1; k <= 7; ++k) {
    const Inputs inputs = {number(1 + 0.3 * k), vector({std::sin(k), std::cos(2 * k), std::sin(5 * k)}),
                           vector({std::cos(k), std::sin(3 * k), std::cos(7 * k)})};
    add_case(exercise, "generic " + std::to_string(k), inputs, right_momentum);
  }
  add_case(exercise, "at rest", {number(2), vector({0, 0, 0}), vector({0, 0, 0})}, right_momentum);
  exercise.cases.back().group = Group::special;
  exercise.cases.back().deciding = false;
  return exercise;
}

ExerciseReference sound_momentum() {
  ExerciseReference exercise = momentum();
  add_misconception(exercise, "no_two", "The velocity v enters twice, not once.", momentum_with(1, 1));
  add_misconception(exercise, "minus", "The two velocities add up.", momentum_with(1, -2));
  add_misconception(exercise, "exchanged", "You exchange u and v.", momentum_with(2, 1));
  add_term(exercise, "m u", 1, momentum_with(1, 0));
  add_term(exercise, "m v", 2, momentum_with(0, 1));
  exercise.routes = {{"as it stands", outputs(exercise, right_momentum)},
                     {"with rounding errors", outputs(exercise, momentum_with(1 + 1e-14, 2 - 1e-14))},
                     {"with others", outputs(exercise, momentum_with(1 - 2e-14, 2 + 1e-14))}};

  exercise.sweep.title = "momentum over mass";
  exercise.sweep.x_label = "m (kg)";
  exercise.sweep.y_label = "p (kg m/s)";
  exercise.sweep.components = {{"p_x", 0, 0}};
  for (double mass : {0.0, 1.0}) {
    const Inputs inputs = {number(mass), vector({1, 0, 0}), vector({0, 1, 0})};
    exercise.sweep.x.push_back(mass);
    exercise.sweep.inputs.push_back(inputs);
    exercise.sweep.expected.push_back(right_momentum(inputs));
    for (Misconception& wrong : exercise.misconceptions) wrong.sweep_outputs.push_back(vector({mass, not_a_number, 0}));
  }
  return exercise;
}

ExerciseReference given_results(Kind kind, std::vector<Value> expected) {
  ExerciseReference exercise;
  exercise.name = "given";
  exercise.signature = "Anything given(int k)";
  exercise.arguments = {{"k", Kind::integer, units::none}};
  exercise.result_kind = kind;
  exercise.result_name = "y";
  exercise.result_units = {units::none};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    add_case(exercise, "number " + std::to_string(k), {number(static_cast<double>(k))},
             [&](const Inputs&) { return expected[k]; });
  }
  return exercise;
}

Reply returning(Value value) {
  Reply reply;
  reply.ending = Ending::returned;
  reply.value = std::move(value);
  return reply;
}

Reply ending(Ending how, std::string text) {
  Reply reply;
  reply.ending = how;
  reply.text = std::move(text);
  return reply;
}

Observation observed(const std::vector<Value>& values) {
  Observation observation;
  for (const Value& value : values) observation.replies.push_back(returning(value));
  return observation;
}

Answers all_answers(const std::vector<Value>& values) { return {values.begin(), values.end()}; }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace workbook::testing
