// Why an answer is wrong: every diagnosis where it is true, and none where it is not. The wording is in
// golden/diagnoses.txt.
#include "checker/explain/explainers.hpp"
#include "checker/explain/values/diagnosis.hpp"
#include "checker/judging/judge.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace workbook::testing {
namespace {

using Values = std::vector<Value>;

/// A wrong answer, and kind and name of each diagnosis of it.
struct Diagnosed {
  std::string about;
  Exercise exercise;
  Values values;
  std::string names;  ///< "property symmetric, place place"
};
using Table = std::vector<Diagnosed>;

void add(Table& table, const std::string& about, const Exercise& exercise, const Values& values,
         const std::string& names = "") {
  table.push_back({about, exercise, values, names});
}

Exercise momentum_with_terms() {
  Exercise exercise = sound_momentum();
  exercise.misconceptions.clear();
  return exercise;
}

/// Generic vectors of a length.
Exercise generic_vectors(Kind kind, int size, Unit unit = units::none) {
  Values expected(4, {size, 1, {}});
  for (std::size_t k = 0; k < 4; ++k)
    for (int n = 0; n < size; ++n) expected[k].numbers.push_back(std::sin(3 * static_cast<double>(k) + 7 * n + 4));
  Exercise exercise = given_results(kind, expected);
  exercise.result_units = {unit};
  return exercise;
}

Values times(const Exercise& exercise, double factor) {
  Values values;
  for (const Case& one : exercise.cases) values.push_back(to_value(factor * as_matrix(one.expected)));
  return values;
}

Values in_order(const Exercise& exercise, const std::vector<int>& order) {
  Values values;
  for (const Case& one : exercise.cases) values.push_back(to_value(as_matrix(one.expected)(order, Eigen::all)));
  return values;
}

Table misconceptions() {
  Table table;
  const Exercise sound = sound_momentum();
  for (const Misconception& wrong : sound.misconceptions)
    add(table, wrong.name, sound, wrong.outputs, "misconception " + wrong.name);
  const Values& wrong = sound.misconceptions[0].outputs;
  Values mixed = outputs(sound, right_momentum);
  for (std::size_t i : {2, 4, 5}) mixed[i] = wrong[i];
  add(table, "not at all cases", sound, mixed, "misconception no_two");
  mixed = wrong;
  for (Value& value : mixed)
    for (double& number : value.numbers) number *= 1 + 1e-6;  // as after an integration in large steps
  add(table, "a term to six digits", sound, mixed, "term m v");
  Exercise without_terms = sound;
  without_terms.terms.clear();
  add(table, "to six digits", without_terms, mixed, "misconception no_two");
  for (std::size_t i = 0; i < mixed.size(); ++i)
    for (double& number : mixed[i].numbers) number *= 1 + 3e-4 * std::sin(static_cast<double>(5 * i));
  add(table, "to three digits", without_terms, mixed, "misconception no_two");
  mixed = outputs(sound, right_momentum);
  for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i].numbers[1] = wrong[i].numbers[1];
  add(table, "in one component", sound, mixed, "difference difference");
  Exercise unnamed = sound;
  unnamed.misconceptions.clear();
  add(table, "in one component, without a name", unnamed, mixed, "difference difference");

  // Where it does not decide, a misconception explains nothing.
  Exercise right = momentum();
  add_misconception(right, "right", "You are right, and yet.", right_momentum);
  mixed = outputs(right, right_momentum);
  mixed.back().numbers[0] = 1;
  add(table, "wrong where it does not decide", right, mixed);

  Exercise not_finite = momentum();
  add_misconception(not_finite, "divided", "You divide by the second component of zero.", [](const Inputs& in) {
    return vector({in[0].numbers[0], not_a_number, 1});
  });
  add(table, "not finite", not_finite, not_finite.misconceptions[0].outputs, "misconception divided");

  Exercise triple = generic_vectors(Kind::vector3, 3);
  add_misconception(triple, "ones", "You give ones.", [](auto&) { return vector({1, 1, 1}); });
  mixed = times(triple, 1);
  for (Value& value : mixed) value.numbers[1] = 7;
  add(table, "in one component, by no formula", triple, mixed, "place place");

  Exercise turns = generic_vectors(Kind::vector2, 2, units::radian);
  mixed = times(turns, 1);
  for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i].numbers[1] += 2 * std::numbers::pi * static_cast<double>(i);
  add(table, "whole turns too many", turns, mixed, "transform whole_turns");
  for (Value& value : mixed) value.numbers[0] -= std::numbers::pi;
  add(table, "half a turn too few", turns, mixed, "transform whole_turns");
  turns.result_units = {units::metre};
  add(table, "no angle", turns, mixed);

  const Eigen::Matrix3d V = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3d signs = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  Exercise axes = eigenvectors(to_value(V * Eigen::Vector3d(1, 2, 4).asDiagonal() * V.transpose()), to_value(V));
  axes.misconceptions = {{"rows", "The axes are your rows.", "", {to_value(V.transpose())}, {}}};
  add(table, "eigenvectors as rows, other signs", axes, {to_value(signs * V.transpose())}, "misconception rows");

  const Eigen::Matrix3d sorted = Eigen::Vector3d(1, 2, 4).asDiagonal();
  const Value tensor = to_value(V * sorted * V.transpose());
  const Exercise two = [&] {
    Exercise made = eigenvectors(tensor, to_value(V));
    made.cases.push_back(made.cases.front());
    return made;
  }();
  const Value in_order = to_value(V), another_order = to_value(V(Eigen::all, {1, 2, 0}));
  add(table, "axes in another order", two, {in_order, another_order}, "entry order");
  add(table, "axes left-handed", two, {in_order, to_value(-V)}, "entry handedness");
  add(table, "no axes", two, {in_order, diagonal(1, 1, 1)});
  Exercise angles = given_results(Kind::vector3, {vector({1, 0.5, 2})}, Comparison::attitude_by_angles);
  add(table, "θ negative", angles, {vector({1 + std::numbers::pi, -0.5, 2 + std::numbers::pi})}, "property range");
  Exercise pitched = given_results(Kind::vector3, {vector({1, 0.5, 2})}, Comparison::attitude_by_yaw_pitch_roll);
  add(table, "pitch beyond a right angle", pitched,
      {vector({1 + std::numbers::pi, std::numbers::pi - 0.5, 2 + std::numbers::pi})}, "property range");
  Exercise turned = given_results(Kind::vector3, {vector({0, 0, 2})}, Comparison::rotation_by_vector);
  add(table, "the long way round", turned, {vector({0, 0, 2 - 2 * std::numbers::pi})}, "property range");
  return table;
}

Table terms() {
  Table table;
  for (const auto& [of_u, of_v, name] : std::vector<std::tuple<double, double, std::string>>{
           {1, 1, "m v"}, {1, -2, "m v"}, {0.5, 2, "m u"}, {1, 0, "m v"}, {2, 1, "m u"}, {1, 2 + 1e-5, ""}})
    add(table, fmt::format("{} m u + {} m v", of_u, of_v), momentum_with_terms(),
        outputs(momentum(), momentum_with(of_u, of_v)), name.empty() ? "accuracy near" : "term " + name);
  add(table, "3 m v, where m v is a misconception", sound_momentum(), outputs(momentum(), momentum_with(1, 3)),
      "term m v");
  // m u_0 times the unit matrix.
  Exercise unit = given_results(Kind::matrix3, {});
  unit.arguments = momentum().arguments;
  const auto with = [](const Eigen::Matrix3d& shape) {
    return [=](const Inputs& in) {
      return to_value(in[0].numbers[0] *
                      (in[1].numbers[0] * shape + Eigen::Vector3d(as_matrix(in[2])).asDiagonal().toDenseMatrix()));
    };
  };
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity(), ones = Eigen::Matrix3d::Ones();
  for (const Case& each : momentum().cases) add_case(unit, each.name, each.inputs, with(one));
  unit.cases.back().scale = {1};
  unit.cases.back().deciding = false;
  add(table, "no term is declared", unit, outputs(unit, with(ones)), "place place");
  add_term(unit, "m u_0 1", 1, [](const Inputs& in) {
    return to_value(in[0].numbers[0] * in[1].numbers[0] * Eigen::Matrix3d::Identity());
  });
  add(table, "a term in every entry", unit, outputs(unit, with(ones)), "term m u_0 1");
  add(table, "half a term in every entry", unit, outputs(unit, with(one + 0.5 * (ones - one))), "place place");
  // A term too small to show is not blamed for rounding errors in it.
  Exercise three = momentum_with_terms();
  add_term(three, "small", 0, [](const Inputs& in) { return vector({3e-8 * std::sin(40 * in[1].numbers[1]), 0, 0}); });
  for (const auto& [of_u, of_small, name] :
       std::vector<std::tuple<double, double, std::string>>{{1, 1e-3, "m v"}, {1, 10, "m v"}, {3, 10, "m u"}}) {
    Values values = outputs(momentum(), momentum_with(of_u, 1));
    for (std::size_t i = 0; i < 9; ++i) values[i].numbers[0] += of_small * three.terms[2].outputs[i].numbers[0];
    add(table, fmt::format("{} m u, and {} times a small term", of_u, of_small), three, values, "term " + name);
  }
  return table;
}

Table transforms() {
  const double degrees = 180 / std::numbers::pi;
  const Exercise triple = generic_vectors(Kind::vector3, 3);
  const Exercise angles = generic_vectors(Kind::vector3, 3, units::radian_per_second);
  const Exercise pair = generic_vectors(Kind::vector2, 2);
  const Exercise four = generic_vectors(Kind::vector, 4);
  const Exercise six = generic_vectors(Kind::vector, 6);
  const Exercise points = given_results(Kind::points, {three_rows({{1, 2}, {3, 4}, {5, 6}})});
  const Exercise matrix = given_results(Kind::matrix3, {three_rows({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}})});
  const Value transposed = three_rows({{1, 4, 7}, {2, 5, 8}, {3, 6, 9}});
  Table table;
  for (double factor : {-1.0, 2.0, 0.5, -1.5, 0.0, degrees})
    for (const Exercise& exercise : {momentum(), momentum_with_terms()})
      add(table, fmt::format("{:.3} times", factor), exercise, times(exercise, factor),
          factor == 0 ? "transform zero" : "transform factor");
  add(table, "2 times a single number", given_results(Kind::number, {number(3)}), {number(6)});
  add(table, "degrees", angles, times(angles, degrees), "transform degrees");
  add(table, "converted twice", angles, times(angles, 1 / degrees), "transform converted_twice");
  add(table, "2, 3, 1", triple, in_order(triple, {1, 2, 0}), "transform permuted");
  add(table, "2, 1", pair, in_order(pair, {1, 0}), "transform permuted");
  add(table, "2, 3, 4, 1", four, in_order(four, {1, 2, 3, 0}), "transform permuted");
  add(table, "six reversed", six, in_order(six, {5, 4, 3, 2, 1, 0}), "transform reversed");
  add(table, "two of six exchanged", six, in_order(six, {1, 0, 2, 3, 4, 5}), "transform other_places");
  add(table, "one component twice", pair, in_order(pair, {0, 0}), "place place");
  add(table, "rows of points", points, in_order(points, {2, 1, 0}), "transform permuted");
  add(table, "transposed", matrix, {transposed}, "transform transposed");

  // A factor that is missing, of the whole and of one component.
  Exercise heavier = momentum();
  add(table, "times m²", heavier,
      outputs(heavier,
              [](const Inputs& in) { return to_value(std::pow(in[0].numbers[0], 2) * as_matrix(right_momentum(in))); }),
      "transform missing_factor");
  add(table, "one component without m", heavier,
      outputs(heavier,
              [](const Inputs& in) {
                Value value = right_momentum(in);
                value.numbers[1] /= in[0].numbers[0];
                return value;
              }),
      "transform missing_factor");

  Exercise swapped = momentum();
  swapped.input_transforms = {{"swapped", "u and v exchanged", outputs(swapped, momentum_with(2, 1))}};
  add(table, "changed inputs", swapped, swapped.input_transforms[0].outputs, "input_transform swapped");

  // What explains an answer wholly leaves out the properties that it lacks.
  Exercise positive = given_results(Kind::vector2, {vector({1, 2}), vector({2, 3})});
  add_property(positive, PropertyKind::nonnegative, "No component is negative");
  add(table, "negative", positive, times(positive, -1), "transform factor");
  add(table, "not the negative", positive, {vector({-1, -2}), vector({-2, -4})}, "property nonnegative");
  return table;
}

/// Two mistakes at once.
Table pairs() {
  Table table;
  const Exercise right = generic_vectors(Kind::vector3, 3);
  const auto wrong = [&](double phase) {
    Values values = times(right, 1);
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t n = 0; n < 3; ++n)
        values[i].numbers[n] += std::cos(phase + 5 * static_cast<double>(i) + 11 * static_cast<double>(n * n));
    return values;
  };
  Exercise known = right;
  known.misconceptions = {{"first", "This is the first mistake.", "", wrong(1), {}},
                          {"second", "This is the second mistake.", "", wrong(2), {}}};
  known.input_transforms = {{"third", "another input", wrong(3)}};
  const auto made_of = [&](const Exercise& exercise, const auto& number) {
    Values values = times(exercise, 1);
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t n = 0; n < 3; ++n)
        values[i].numbers[n] = number(values[i].numbers[n], exercise.misconceptions[0].outputs[i].numbers[n],
                                      exercise.input_transforms[0].outputs[i].numbers[n], n);
    return values;
  };
  add(table, "a mistake in one component", known,
      made_of(known, [](double x, double a, double, std::size_t n) { return n == 1 ? a : x; }), "misconception first");
  add(table, "a mistake in one component, and the result for another input in another", known,
      made_of(known, [](double x, double a, double b, std::size_t n) { return n == 1   ? a
                                                                              : n == 2 ? b
                                                                                       : x; }),
      "misconception first");
  add(table, "a mistake in one component, and nothing known in another", known,
      made_of(known, [](double x, double a, double, std::size_t n) { return n == 1   ? a
                                                                            : n == 2 ? 7.5
                                                                                     : x; }),
      "misconception first");
  Values both = times(known, 1);
  for (std::size_t i = 0; i < both.size(); ++i)
    for (const std::size_t n : {1, 2}) both[i].numbers[n] = known.misconceptions[n - 1].outputs[i].numbers[n];
  add(table, "two mistakes in two components", known, both, "misconception first");
  for (Value& value : both) value.numbers[0] = 7.5;
  add(table, "two mistakes in two components, and nothing known in the third", known, both, "misconception first");
  const auto sum = [](double x, double a, double b, std::size_t) { return a + b - x; };
  add(table, "what two mistakes add", known, made_of(known, sum), "misconception first");
  add(table, "the factors of two mistakes", known,
      made_of(known, [](double x, double a, double b, std::size_t) { return a * b / x; }), "misconception first");
  Exercise many = known;
  many.misconceptions.push_back({"fourth", "This is a half of both.", "", {}, {}});
  many.misconceptions.push_back({"fifth", "This is the other half.", "", {}, {}});
  many.misconceptions[2].outputs = wrong(4);
  many.misconceptions[3].outputs = made_of(known, sum);
  for (std::size_t i = 0; i < right.cases.size(); ++i)
    for (std::size_t n = 0; n < 3; ++n)
      many.misconceptions[3].outputs[i].numbers[n] +=
          right.cases[i].expected.numbers[n] - many.misconceptions[2].outputs[i].numbers[n];
  add(table, "what either of two pairs of mistakes adds", many, made_of(many, sum));
  return table;
}

/// Where it is wrong, and what that has in common.
Table patterns() {
  Table table;
  add(table, "no m v", momentum(), outputs(momentum(), momentum_with(1, 1)), "difference difference");
  add(table, "too much m u", momentum(), outputs(momentum(), momentum_with(1.5, 1)), "difference difference");

  Values coarse = outputs(momentum(), right_momentum);
  for (std::size_t i = 0; i < coarse.size(); ++i)
    for (double& number : coarse[i].numbers) number *= 1 + 1e-5 * static_cast<double>(i % 3 + 1);
  add(table, "four digits", momentum(), coarse, "accuracy near");
  Values single = outputs(momentum(), right_momentum);
  for (Value& value : single)
    for (double& number : value.numbers) number = static_cast<float>(number * 1.1) / 1.1;
  add(table, "a float", momentum(), single, "accuracy accuracy");

  Values split = outputs(momentum(), right_momentum);
  for (std::size_t i = 0; i < 9; ++i)
    if (momentum().cases[i].inputs[1].numbers[0] < 0) split[i] = vector({static_cast<double>(i), 7, 0});
  add(table, "wrong where u_1 < 0", momentum(), split, "split split");

  Exercise angled = momentum();
  for (int k = 1; k <= 12; ++k)
    add_case(angled, fmt::format("an angle {}", k),
             {number(k), vector({std::cos(k), std::sin(k), 0.1}), vector({std::cos(3 * k), std::sin(3 * k), 0.3})},
             right_momentum);
  Values obtuse = outputs(angled, right_momentum);
  for (std::size_t i = 0; i < obtuse.size(); ++i) {
    const Inputs& inputs = angled.cases[i].inputs;
    if (as_matrix(inputs[1]).cwiseProduct(as_matrix(inputs[2])).sum() < 0)
      obtuse[i] = vector({std::sin(static_cast<double>(i * i)), 7, 0});
  }
  add(table, "wrong where two vectors have an obtuse angle", angled, obtuse, "split split");

  Values once = outputs(momentum(), right_momentum);
  once[4].numbers[2] += 1;
  add(table, "one component at one case", momentum(), once);
  // Zeros are not said to belong elsewhere.
  const Exercise zero = given_results(Kind::vector3, Values(4, vector({1, 0, 2})));
  add(table, "zero, as another component", zero, Values(4, vector({0, 0, 2})), "place place");

  Exercise moved = momentum();
  for (int base : {1, 2}) add_generated(moved, base, 2, vector({7, 8, 9}), right_momentum);
  const Function without_v = [](const Inputs& in) { return vector({0, in[0].numbers[0], 1}); };
  add(table, "v is not used", moved, outputs(moved, without_v), "difference difference");

  for (int base : {3, 4, 5}) add_generated(moved, base, 2, vector({4, 1, -3}), right_momentum);
  const Function of_m = [](const Inputs& in) { return vector({std::sin(9 * in[0].numbers[0]), 7, 0.3}); };
  add(table, "v never has an effect, and what is returned is nothing known", moved, outputs(moved, of_m),
      "independence no_effect");

  Exercise numbered = momentum();
  for (int base : {1, 2, 3, 4})
    for (const int entry : {0, 2}) {
      Value v = numbered.cases[static_cast<std::size_t>(base)].inputs[2];
      v.numbers[static_cast<std::size_t>(entry)] += 5;
      add_generated(numbered, base, 2, v, right_momentum);
      numbered.cases.back().entry = entry;
    }
  const Function of_last = [](const Inputs& in) {
    return vector({std::sin(in[2].numbers[2]), std::cos(7 * in[2].numbers[2]), 1});
  };
  add(table, "one component of v never has an effect", numbered, outputs(numbered, of_last), "independence no_effect");
  numbered.cases.erase(numbered.cases.end() - 4, numbered.cases.end());
  add(table, "too few pairs of cases to say so", numbered, outputs(numbered, of_last));

  Values signs = outputs(momentum(), right_momentum);
  for (std::size_t i = 0; i < signs.size(); i += 2) signs[i].numbers[1] *= -1;
  add(table, "a sign is wrong at every other case", momentum(), signs, "transform signs");

  // Cases whose names are all that they have in common.
  Exercise named = momentum();
  for (int k : {1, 2, 3, 4, 5})
    add_case(named, fmt::format("a collision {}", k),
             {number(1.5 * k), vector({2.5 - k, k * k / 4.0, k % 2 - 0.5}), vector({1.0 - k % 3, 2, 1.0 * k})},
             right_momentum);
  Values collided = outputs(named, right_momentum);
  for (std::size_t i = 9; i < collided.size(); ++i)
    collided[i].numbers = {0.3 * static_cast<double>(i), 7 - static_cast<double>(i), static_cast<double>(i % 3)};
  add(table, "wrong at all cases of a name", named, collided, "split kinds");

  Exercise still = momentum();
  for (int k : {1, 2, 3})
    add_case(still, fmt::format("at rest {}", k), {number(k), vector({0, 0, 0}), vector({1, 2, 1.0 * k})},
             right_momentum);
  Values at_rest = outputs(still, right_momentum);
  for (std::size_t i = 9; i < at_rest.size(); ++i) at_rest[i] = vector({0, 0, 0});
  add(table, "zero at some of the cases where u is", still, at_rest);
  still.cases[8].inputs[1].numbers[0] = 1e-3;
  still.cases[8].expected = right_momentum(still.cases[8].inputs);
  at_rest[8] = still.cases[8].expected;
  add(table, "zero where u is, and only there", still, at_rest, "split split");
  return table;
}

/// A number that follows from two others.
using OfTwo = std::function<double(double, double)>;
Exercise of_two(const Argument& one, const Argument& other, Unit unit, const OfTwo& f) {
  Exercise exercise;
  exercise.arguments = {one, other};
  exercise.result_kind = Kind::number;
  exercise.result_units = {unit};
  for (int k = 1; k <= 20; ++k)
    add_case(exercise, fmt::format("pair {}", k), {number(0.1 * k), number(0.5 + (7 * k) % 20 / 10.0)},
             [&](const Inputs& in) { return number(f(in[0].numbers[0], in[1].numbers[0])); });
  return exercise;
}

Values of(const Exercise& exercise, const OfTwo& f) {
  return outputs(exercise, [&](const Inputs& in) { return number(f(in[0].numbers[0], in[1].numbers[0])); });
}

/// The first sentence of an explainer that calls the function.
std::string told_by(Explainer& look, const Exercise& exercise, const OfTwo& wrong, const std::string& text = "") {
  const auto function = [&](const Inputs& in) { return number(wrong(in[0].numbers[0], in[1].numbers[0])); };
  const Observation observation = observed(outputs(exercise, function));
  const Judgement judgement = judge(exercise, observation);
  const Ask ask = [&](const std::vector<PlannedCall>& calls) {
    std::vector<Reply> replies;
    for (const PlannedCall& call : calls) replies.push_back(returning(function(call.inputs)));
    return replies;
  };
  const Submission submission{"", "", text};
  const CompileTask compile_task{submission, "", ""};
  const Compilation compilation;
  const Toolchain toolchain;
  const std::filesystem::path cache;
  const Evidence evidence{
      {submission, exercise, observation, judgement}, compile_task, compilation, ask, toolchain, cache};
  Search search{evidence, answers_of(exercise, observation.replies), {}};
  look(search);
  return search.reasons.empty() ? "" : search.reasons.front().sentence;
}

/// What an error is a function of, and where it is.
Table laws() {
  Table table;
  const Argument a{"a", Kind::number, units::metre}, b{"b", Kind::number, units::metre};
  const Exercise root = of_two(a, b, units::metre, [](double x, double y) { return std::sqrt(x * x + 2 * x * y); });
  add(table, "a term missing under a root", root,
      of(root, [](double x, double y) { return std::sqrt(x * x + 2 * x * y + y * y / 4); }), "difference difference");
  const Exercise inverse = of_two(a, b, units::metre, [](double x, double y) { return 1 / (1 / x + 1 / y); });
  add(table, "twice a term in a denominator", inverse,
      of(inverse, [](double x, double y) { return 1 / (1 / x + 2 / y); }), "difference difference");

  const Argument rate{"rate", Kind::number, units::none / units::second}, t{"t", Kind::number, units::second};
  const Exercise decay = of_two(rate, t, units::none, [](double r, double s) { return std::exp(-r * s); });
  add(table, "a factor that no power is", decay,
      of(decay, [](double r, double s) { return std::exp(-r * s) * (1 + std::sin(9 * r) / 4); }));

  const Argument angle{"angle", Kind::number, units::radian};
  Exercise area = of_two(a, angle, units::metre, [](double x, double y) { return x * x * std::sin(y); });
  add(table, "a factor of either sign", area,
      of(area, [](double x, double y) { return x * x * std::sin(y) * std::cos(y); }), "transform missing_factor");
  const Exercise sum = of_two(a, angle, units::metre, [](double x, double y) { return x + x * std::sin(y); });
  add(table, "a term with a factor more", sum,
      of(sum, [](double x, double y) { return x + x * std::sin(y) * std::sin(y); }), "difference difference");
  add(table, "so small that every small number is near", area,
      of(area, [](double x, double y) { return 1e-4 * x * x * x * y; }));
  const auto cosine = [](double x, double y) { return x * x * (std::cos(y) - 3); };
  area.misconceptions = {{"cosine", "The sine is a cosine here.", "", of(area, cosine), {}}};
  add(table, "a known mistake without its sign", area,
      of(area, [&](double x, double y) { return std::abs(cosine(x, y)); }), "misconception cosine");
  area.misconceptions = {{"negative", "The sign is wrong.", "", times(area, -1), {}}};
  area.cases[3].deciding = false;
  Values nearly = times(area, 1);
  nearly[3].numbers[0] += 1;
  add(table, "right where it decides: no mistake with the other sign", area, nearly);
  area.misconceptions.clear();
  add(table, "a factor and the other sign", area,
      of(area, [](double x, double y) { return -x * x * std::sin(y) * std::cos(y); }), "transform missing_factor");
  Exercise obtuse = of_two(a, angle, units::radian, [](double x, double y) { return x + y / 5; });
  add(table, "an angle by its sine", obtuse,
      of(obtuse, [](double x, double y) { return std::asin(std::sin(x + y / 5)); }), "transform complement");
  obtuse.regions = {{"the angle is obtuse", {}}};
  for (const Case& one : obtuse.cases)
    obtuse.regions[0].holds.push_back(one.expected.numbers[0] > std::numbers::pi / 2);
  add(table, "in a region of which the lecture speaks", obtuse,
      of(obtuse, [](double x, double y) { return x + y / 5 < std::numbers::pi / 2 ? x + y / 5 : x * y; }),
      "split split");

  // At one more case, where digits are lost, it is wrong elsewhere.
  obtuse.regions = {{"y is large", {}}};
  for (const Case& one : obtuse.cases) obtuse.regions[0].holds.push_back(one.inputs[1].numbers[0] > 1.2);
  const auto wrong_at_large = [](double x, double y, double edge) { return y > edge ? 7 : x + y / 5; };
  Values mostly = of(obtuse, [&](double x, double y) { return wrong_at_large(x, y, 1.2); });
  mostly[2].numbers[0] += 1;
  add(table, "wrong in a region, and at one case elsewhere", obtuse, mostly, "split split");
  for (const std::size_t i : {3, 5}) mostly[i].numbers[0] += 1;
  add(table, "wrong in a region, and at some cases elsewhere", obtuse, mostly);

  const Exercise pair = momentum();
  Values part = outputs(pair, right_momentum);
  for (std::size_t i = 0; i < part.size(); ++i) {
    part[i].numbers[0] += pair.cases[i].inputs[0].numbers[0] * pair.cases[i].inputs[1].numbers[1];
    part[i].numbers[2] = std::cos(5 * static_cast<double>(i * i));
  }
  add(table, "one component by a product, another by nothing", pair, part, "difference difference");

  Exercise many = momentum();
  for (int k = 1; k <= 12; ++k)
    add_case(many, fmt::format("another {}", k),
             {number(1 + 0.1 * k), vector({2.0 - k, k * k / 9.0, 1.0 + k % 4}), vector({k % 3 + 0.5, 2, 1.0 * k})},
             right_momentum);
  Values exchanged = outputs(many, right_momentum);
  for (std::size_t i = 0; i < exchanged.size(); i += 2) std::swap(exchanged[i].numbers[0], exchanged[i].numbers[1]);
  add(table, "exchanged at every other case", many, exchanged, "transform permuted, place place");
  for (std::size_t i = 1; i < exchanged.size(); i += 4) exchanged[i].numbers[0] *= 1 + 1e-7;
  add(table, "exchanged at some cases, and without the last digits at others", many, exchanged,
      "transform permuted, place place");
  return table;
}

/// Functions of angles, and what is wrong beyond some size.
Table sizes() {
  Table table;
  const Argument rate{"rate", Kind::number, units::none / units::second}, t{"t", Kind::number, units::second};
  const auto add_of = [&](const std::string& about, const Exercise& exercise, const std::string& names,
                          const OfTwo& wrong) { add(table, about, exercise, of(exercise, wrong), names); };
  const Exercise turned = of_two(rate, t, units::radian, [](double r, double s) { return std::atan2(r, 1 + s); });
  add_of("twice the tangent", turned, "transform missing_factor",
         [](double r, double s) { return std::atan2(2 * r, 1 + s); });

  Exercise long_run = of_two(rate, t, units::none, [](double r, double s) { return std::cos(r * s); });
  for (int k = 1; k <= 30; ++k)
    add_case(long_run, fmt::format("another pair {}", k), {number(0.3 + (11 * k) % 30 / 20.0), number(0.2 * k)},
             [](const Inputs& in) { return number(std::cos(in[0].numbers[0] * in[1].numbers[0])); });
  add_of("right where rate and time are small", long_run, "split threshold",
         [](double r, double s) { return r * s < 2 ? std::cos(r * s) : std::sin(7 * r * s * s); });
  Values all_but = of(long_run, [](double r, double s) { return r * s < 2 ? std::cos(r * s) : 3 + std::sin(s); });
  for (const std::size_t i : {2, 30, 35}) all_but[i].numbers[0] = 3;
  add(table, "and at some where they are not", long_run, all_but);
  return table;
}

struct Broken {
  PropertyKind property;
  Kind kind;
  Value expected;
  Value actual;
};

std::vector<Broken> broken_properties() {
  using P = PropertyKind;
  const Value symmetric = three_rows({{2, 1, 0}, {1, 2, 0}, {0, 0, 2}});
  const Value antisymmetric = three_rows({{0, 1, 2}, {-1, 0, 3}, {-2, -3, 0}});
  const Value turned = three_rows({{0, -1, 0}, {1, 0, 0}, {0, 0, 1}});
  return {
      {P::symmetric, Kind::matrix3, symmetric, three_rows({{2, 1, 0}, {-1.5, 2, 0}, {0, 0, 2}})},
      {P::symmetric, Kind::matrix3, symmetric, three_rows({{2, 1, 0}, {1 + 1e-7, 2, 0}, {0, 0, 3}})},
      {P::antisymmetric, Kind::matrix3, antisymmetric, three_rows({{0, 1, 2}, {-1, 0, 3}, {-2, 5, 0}})},
      {P::antisymmetric, Kind::matrix3, antisymmetric, three_rows({{0, 1, 2}, {-1, 0, 3}, {-2, -3, 4}})},
      {P::positive_semidefinite, Kind::matrix3, diagonal(1, 2, 0), diagonal(1, 2, -0.5)},
      {P::rotation_matrix, Kind::matrix3, turned, three_rows({{0, -1, 0}, {2, 0, 0}, {0, 0, 1}})},
      {P::rotation_matrix, Kind::matrix3, turned, three_rows({{1, 0.5, 0}, {0, 0.875, 0}, {0, 0, 1}})},
      {P::rotation_matrix, Kind::matrix3, turned, three_rows({{0, 1, 0}, {1, 0, 0}, {0, 0, 1}})},
      {P::unit_norm, Kind::vector3, vector({0, 0.6, 0.8}), vector({0, 3, 4})},
      {P::unit_norm, Kind::vector3, vector({0, 0.6, 0.8}), vector({0, 0.6, 0.80000005})},
      {P::ascending, Kind::vector3, vector({1, 2, 2}), vector({2, 3, 1})},
      {P::nonnegative, Kind::number, number(2), number(-3)},
      {P::nonnegative, Kind::vector2, vector({0, 2}), vector({1, -3})},
  };
}

Exercise with_property(const Broken& broken) {
  // A second case keeps the answer from being a multiple of the right one.
  Exercise exercise = given_results(broken.kind, {broken.expected, broken.expected});
  add_property(exercise, broken.property, "right results are so: always.");
  return exercise;
}

Table properties() {
  Table table;
  for (const Broken& broken : broken_properties())
    add(table, "not " + to_string(broken.property), with_property(broken), {broken.expected, broken.actual},
        "property " + to_string(broken.property));
  add(table, "not conserved", conserved(), {three_rows({{1, 0}, {0, 1.02}, {2, 2}})},
      "property constant_weighted_square, place place");

  Exercise exercise = given_results(Kind::vector3, {vector({0, 2, 0}), vector({0, 0, 3})});
  exercise.arguments = {{"omega", Kind::vector3, units::radian_per_second}};
  exercise.cases[0].inputs = {vector({4, 0, 0})};
  exercise.cases[1].inputs = {vector({0, 0, 0})};  // everything is perpendicular to zero
  exercise.properties = {{PropertyKind::orthogonal_to_argument, "ω × r is perpendicular to ω.", "", 0, {}}};
  add(table, "not perpendicular", exercise, {vector({0.5, 2, 1}), vector({1, 2, 3})},
      "property orthogonal_to_argument");
  add(table, "perpendicular, and wrong", exercise, {vector({0, 1, 5}), vector({1, 2, 4})});
  return table;
}

}  // namespace

TEST_CASE("What is said of a wrong answer has the right kind and name") {
  std::string text;
  for (const auto& table : {misconceptions, terms, transforms, pairs, patterns, laws, sizes, properties}) {
    for (const Diagnosed& one : table()) {
      std::string names;
      text += one.about + "\n";
      for (const Reason& each : diagnose(one.exercise, all_answers(one.values))) {
        names += (names.empty() ? "" : ", ") + to_string(each.kind) + " " + each.name;
        text += fmt::format("  {} {}: {} ({})\n", to_string(each.kind), each.name, each.sentence, each.notes);
      }
      CHECK_MESSAGE(names == one.names, one.about << ": " << names);
    }
  }
  compare_with_golden_file("diagnoses.txt", text);
}

TEST_CASE("Digits that are chance are told however few are right, and the edge of a branch is none") {
  const Argument cosine{"cosine", Kind::number, units::none}, sine{"sine", Kind::number, units::none};
  Exercise exercise = of_two(cosine, sine, units::radian, [](double c, double s) { return std::atan2(s, c); });
  exercise.cases.clear();
  for (int k = 0; k < 8; ++k)
    for (const double angle : {1e-9 * (k + 1), 0.1 + 0.1 * k})
      add_case(exercise, fmt::format("{}", angle), {number(std::cos(angle)), number(std::sin(angle))},
               [&](const Inputs&) { return number(angle); });
  const auto arc = [](double c, double) { return std::acos(std::min(c, 1.0)); };
  CHECK(told_by(explain_lost_digits, exercise, arc) ==
        "Where your result is wrong it is nearly right, but its last digits are chance: they change when an input "
        "changes in its 16th digit. Digits are lost in a difference of nearly equal numbers.");
  CHECK(told_by(explain_lost_digits, exercise, arc, "std::acos(c)").starts_with("acos loses half of the digits"));
  CHECK(told_by(explain_lost_digits, exercise, [](double c, double s) { return c == 1 ? 0 : std::atan2(s, c); }) == "");
  CHECK(told_by(explain_lost_digits, exercise, [](double c, double s) { return 2 * std::atan2(s, c); }) == "");
}

TEST_CASE("Nothing is said of a right answer, nor where no value came back") {
  for (const Exercise& exercise : {momentum(), sound_momentum(), conserved()}) {
    CHECK(diagnose(exercise, all_answers(times(exercise, 1))).empty());
    CHECK(diagnose(exercise, Answers(exercise.cases.size())).empty());
  }
}

TEST_CASE("A misconception is not named if one deciding case disagrees or has no value") {
  const Exercise exercise = sound_momentum();
  Answers answers = all_answers(exercise.misconceptions[0].outputs);
  answers.back().reset();  // it does not decide
  CHECK(diagnose_misconception(exercise, answers).has_value());
  answers[5]->numbers[1] += 1e-3;
  CHECK_FALSE(diagnose_misconception(exercise, answers).has_value());
  answers[5].reset();
  CHECK_FALSE(diagnose_misconception(exercise, answers).has_value());
}

TEST_CASE("Of two misconceptions with one message the first stands for both; with two messages neither is named") {
  Exercise exercise = momentum();
  add_misconception(exercise, "no_two", "The velocity v enters twice.", momentum_with(1, 1));
  add_misconception(exercise, "mean", "The velocity v enters twice.", momentum_with(1, 1));
  const Answers answers = all_answers(outputs(exercise, momentum_with(1, 1)));
  CHECK(diagnose_misconception(exercise, answers).value().name == "no_two");
  add_misconception(exercise, "other", "You take the mean.", momentum_with(1, 1));
  CHECK_FALSE(diagnose_misconception(exercise, answers).has_value());
}

TEST_CASE("Nothing is said of terms where the answer is no sum of them, they depend on each other, or numbers lack") {
  Exercise exercise = momentum_with_terms();
  Answers answers = all_answers(outputs(exercise, momentum_with(1, 1)));
  CHECK(diagnose_terms(exercise, answers).has_value());
  Exercise dependent = exercise;
  add_term(dependent, "m (u + v)", 0, momentum_with(1, 1));
  CHECK_FALSE(diagnose_terms(dependent, answers).has_value());
  for (std::size_t i = 1; i < 9; ++i) exercise.cases[i].deciding = false;
  CHECK_FALSE(diagnose_terms(exercise, answers).has_value());
  exercise.cases[1].deciding = true;
  CHECK(diagnose_terms(exercise, answers).has_value());
  for (double odd : {1e-4, not_a_number}) {
    answers[1]->numbers[0] += odd;
    CHECK_FALSE(diagnose_terms(exercise, answers).has_value());
  }
}

TEST_CASE("A property that the result has, or that not even the expected results have, is not told") {
  for (const Broken& broken : broken_properties()) {
    Exercise exercise = with_property(broken);
    CHECK(violation(exercise, exercise.properties[0], 0, broken.expected).size <= 1e-15);
    CHECK(diagnose_properties(exercise, all_answers({broken.expected, broken.expected})).empty());
    exercise.cases[0].expected = broken.actual;
    CHECK(diagnose_properties(exercise, all_answers({broken.actual, broken.actual})).empty());
  }
  const Exercise symmetric =
      with_property({PropertyKind::symmetric, Kind::matrix3, diagonal(1, 2, 3), diagonal(1, 2, 3)});
  const Value nearly = three_rows({{1, 1e-9, 0}, {-1e-9, 2, 0}, {0, 0, 4}});
  CHECK(diagnose_properties(symmetric, all_answers({nearly, diagonal(not_a_number, 1, 1)})).empty());
}

}  // namespace workbook::testing
