// Dimensions, tested by a change of units.
#include "checker/judging/dimensions.hpp"
#include "checker/judging/judge.hpp"
#include "checker/judging/sampling.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace workbook::testing {
namespace {

/// The energy ½ m v² + ½ k x² of masses, speeds, stiffnesses and lengths.
ExerciseReference energy() {
  ExerciseReference exercise = given_results(Kind::number, {});
  exercise.arguments = {{"m", Kind::number, units::kilogram},
                        {"v", Kind::number, units::metre_per_second},
                        {"k", Kind::number, units::newton / units::metre},
                        {"x", Kind::number, units::metre}};
  exercise.result_units = {units::joule};
  for (int k = 1; k <= 6; ++k) {
    add_case(exercise, "case " + std::to_string(k),
             {number(k), number(1 + 0.1 * k), number(2 + 0.2 * k), number(1 / (1.0 + k))}, [](const Inputs& in) {
               const double m = in[0].numbers[0], v = in[1].numbers[0], stiffness = in[2].numbers[0],
                            x = in[3].numbers[0];
               return number(m * v * v / 2 + stiffness * x * x / 2);
             });
  }
  return exercise;
}

Function of_numbers(const std::function<double(double m, double v, double k, double x)>& function) {
  return [function](const Inputs& in) {
    return number(function(in[0].numbers[0], in[1].numbers[0], in[2].numbers[0], in[3].numbers[0]));
  };
}

/// A student's function run at all cases and all probes.
Observation run(const ExerciseReference& exercise, const Function& function) {
  Observation observation = observed(outputs(exercise, function));
  observation.probes = plan_probes(exercise);
  for (UnitProbe& probe : observation.probes) {
    for (std::size_t i : probe.case_indices)
      probe.replies.push_back(returning(function(probe_inputs(exercise, probe, i))));
  }
  return observation;
}

std::vector<std::string> dimension_messages(const ExerciseReference& exercise, const Observation& observation) {
  std::vector<std::string> messages;
  for (const Diagnosis& diagnosis :
       diagnose_dimensions(exercise, answers_of(exercise, observation.replies), observation.probes)) {
    CHECK(diagnosis.kind == DiagnosisKind::dimension);
    messages.push_back(diagnosis.message);
  }
  return messages;
}

std::vector<std::string> dimension_messages(const ExerciseReference& exercise, const Function& function) {
  return dimension_messages(exercise, run(exercise, function));
}

using Messages = std::vector<std::string>;

}  // namespace

TEST_CASE("Probes are planned for the base units that arguments have, at a few deciding cases") {
  const std::vector<UnitProbe> probes = plan_probes(momentum());
  REQUIRE(probes.size() == 3);
  CHECK(probes[0].base == 'k');
  CHECK(probes[0].factor == 1000);
  CHECK(probes[1].base == 'm');
  CHECK(probes[1].factor == 100);
  CHECK(probes[2].base == 's');
  CHECK(probes[2].factor == 1000);
  for (const UnitProbe& probe : probes) {
    CHECK(probe.case_indices == std::vector<std::size_t>{0, 3, 7});
    CHECK(probe.replies.empty());
  }
  CHECK(plan_probes(given_results(Kind::number, {number(1)})).empty());
}

TEST_CASE("The inputs of a probe are the same quantities in the small unit") {
  const ExerciseReference exercise = energy();
  const std::vector<UnitProbe> probes = plan_probes(exercise);
  const auto first_inputs = [&](std::size_t probe) {
    std::vector<double> numbers;
    for (const Value& value : probe_inputs(exercise, probes.at(probe), 0)) numbers.push_back(value.numbers[0]);
    return numbers;
  };
  const auto are_near = [](const std::vector<double>& actual, const std::vector<double>& expected) {
    return std::ranges::equal(actual, expected,
                              [](double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); });
  };
  CHECK(are_near(first_inputs(0), {1000, 1.1, 2200, 0.5}));
  CHECK(are_near(first_inputs(1), {1, 110, 2.2, 50}));
  CHECK(are_near(first_inputs(2), {1, 1.1e-3, 2.2e-6, 0.5}));
}

TEST_CASE("A result of the right dimension is silent, even if it is wrong") {
  CHECK(dimension_messages(energy(), of_numbers([](double m, double v, double k, double x) {
                             return m * v * v + k * x * x / 7;
                           })) == Messages{});
}

TEST_CASE("A wrong power is told with both growths, for every base unit where it is wrong") {
  const ExerciseReference exercise = energy();
  CHECK(dimension_messages(exercise, of_numbers([](double m, double v, double, double) { return m * v; })) ==
        Messages{"With lengths in cm the result should grow 10⁴ times, yours grows 10² times.",
                 "With times in ms the result should shrink 10⁶ times, yours shrinks 10³ times."});
  CHECK(dimension_messages(exercise, of_numbers([](double, double v, double, double) { return v * v; })) ==
        Messages{"With masses in g the result should grow 10³ times, yours does not change."});
  CHECK(dimension_messages(exercise,
                           of_numbers([](double m, double v, double, double) { return m * std::sqrt(m) * v * v; })) ==
        Messages{"With masses in g the result should grow 10³ times, yours grows 3.16e+04 times."});
}

TEST_CASE("A result that should not change with a unit is told so") {
  ExerciseReference exercise = energy();
  exercise.result_units = {units::none};
  CHECK(dimension_messages(exercise, of_numbers([](double m, double, double, double) { return m; })) ==
        Messages{"With masses in g the result should not change, yours grows 10³ times."});
}

TEST_CASE("A sum of different dimensions has no single power, and is told once") {
  CHECK(
      dimension_messages(energy(),
                         of_numbers([](double m, double v, double k, double x) { return m * v + k * x * x; })) ==
      Messages{
          "With lengths in cm your result grows by no single power of ten: quantities of different dimension are being "
          "added, or a number in the formula hides a unit."});
}

TEST_CASE("A single wrong power says more than none, and stands alone") {
  // Linear in every mass, but lengths are mixed.
  CHECK(dimension_messages(
            energy(), of_numbers([](double m, double v, double k, double x) { return m * m * v + k * m * x * x; })) ==
        Messages{"With masses in g the result should grow 10³ times, yours grows 10⁶ times."});
}

TEST_CASE("A result that becomes zero or not finite by a change of units has no single power") {
  const auto messages = dimension_messages(
      energy(), of_numbers([](double m, double v, double, double) { return m > 100 ? 0.0 : m * v * v; }));
  REQUIRE(messages.size() == 1);
  CHECK(contains(messages[0], "With masses in g your result grows by no single power of ten"));
}

TEST_CASE("A sign that changes, as that of an eigenvector may, says nothing about the dimension") {
  CHECK(dimension_messages(energy(), of_numbers([](double m, double v, double, double) {
                             return m > 100 ? -m * v * v : m * v * v;
                           })) == Messages{});
}

TEST_CASE("Where every number has a unit of its own, the component is named") {
  ExerciseReference exercise = energy();
  exercise.result_kind = Kind::vector2;
  exercise.result_units = {units::joule, units::joule * units::joule};
  for (Case& one : exercise.cases) one.expected = vector({1, 1});
  const Function pair = [](const Inputs& in) {
    const double twice = in[0].numbers[0] * in[1].numbers[0] * in[1].numbers[0];
    return vector({twice, twice});
  };
  CHECK(dimension_messages(exercise, pair) ==
        Messages{"With masses in g component 2 of the result should grow 10⁶ times, yours grows 10³ times.",
                 "With lengths in cm component 2 of the result should grow 10⁸ times, yours grows 10⁴ times.",
                 "With times in ms component 2 of the result should shrink 10¹² times, yours shrinks 10⁶ times."});
}

TEST_CASE("Numbers near zero and probes without a value say nothing") {
  ExerciseReference exercise = energy();
  for (Case& one : exercise.cases) one.scale = {1e6};
  const Function wrong = of_numbers([](double m, double v, double, double) { return m * v; });
  CHECK(dimension_messages(exercise, wrong) == Messages{});

  Observation observation = run(energy(), wrong);
  CHECK_FALSE(dimension_messages(energy(), observation).empty());
  for (UnitProbe& probe : observation.probes) probe.replies[1] = ending(Ending::exception);
  CHECK(dimension_messages(energy(), observation) == Messages{});
  for (UnitProbe& probe : observation.probes) probe.replies.clear();
  CHECK(dimension_messages(energy(), observation) == Messages{});
}

TEST_CASE("The errors of an integration are no wrong dimension") {
  const Function inexact = of_numbers([](double m, double v, double k, double x) {
    return (m * v * v + k * x * x / 7) * (1 + 0.02 * std::sin(1e4 * m + 1e3 * v));
  });
  CHECK(dimension_messages(energy(), inexact) == Messages{});
}

TEST_CASE("The judge reports dimensions only where nothing explains the whole answer") {
  const ExerciseReference exercise = energy();
  const Judgement judgement =
      judge(exercise, run(exercise, of_numbers([](double m, double v, double, double) { return m * v; })));
  REQUIRE(judgement.diagnoses.size() == 2);
  CHECK(judgement.diagnoses[0].kind == DiagnosisKind::dimension);
  CHECK(judgement.diagnoses[0].name == "m");

  ExerciseReference known = exercise;
  add_misconception(known, "momentum", "This is the momentum.",
                    of_numbers([](double m, double v, double, double) { return m * v; }));
  const Judgement named =
      judge(known, run(known, of_numbers([](double m, double v, double, double) { return m * v; })));
  REQUIRE(named.diagnoses.size() == 1);
  CHECK(named.diagnoses[0].message == "This is the momentum.");
}

TEST_CASE("A sample is spread from the first to the last, and repeats run backwards") {
  CHECK(spread({4, 5, 6, 7, 8, 9, 10}, 3) == std::vector<std::size_t>{4, 7, 10});
  CHECK(spread({4, 5}, 3) == std::vector<std::size_t>{4, 5});
  CHECK(spread({4, 5}, 1) == std::vector<std::size_t>{4});
  CHECK(spread({}, 3).empty());
  CHECK(plan_repeats(momentum()) == std::vector<std::size_t>{8, 4, 0});
  CHECK(plan_repeats(given_results(Kind::number, {number(1), number(2)})) == std::vector<std::size_t>{1, 0});
}

}  // namespace workbook::testing
