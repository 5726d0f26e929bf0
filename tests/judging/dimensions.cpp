// Dimensions, tested by a change of units; the wording is in golden/dimensions.txt.
#include "checker/explain/values/diagnosis.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace workbook::testing {
namespace {

using D = double;
using Formula = std::function<D(D m, D v, D k, D x)>;

/// The formula once, or, where the exercise asks for two numbers, with a second one.
Function function_of(const Formula& formula, const Formula& second = {}) {
  return [formula, second](const Inputs& in) {
    const auto value = [&](const Formula& of) {
      return of(in[0].numbers[0], in[1].numbers[0], in[2].numbers[0], in[3].numbers[0]);
    };
    return second ? vector({value(formula), value(second)}) : number(value(formula));
  };
}

D momentum_of(D m, D v, D, D) { return m * v; }
D energy_of(D m, D v, D k, D x) { return m * v * v / 2 + k * x * x / 2; }

/// The energy of masses, speeds, stiffnesses and lengths.
Exercise energy(const std::vector<Unit>& result = {units::joule}) {
  Exercise exercise = given_results(result.size() == 2 ? Kind::vector2 : Kind::number, {});
  exercise.arguments = {{"m", Kind::number, units::kilogram},
                        {"v", Kind::number, units::metre_per_second},
                        {"k", Kind::number, units::newton / units::metre},
                        {"x", Kind::number, units::metre}};
  exercise.result_units = result;
  for (int k = 1; k <= 6; ++k)
    add_case(exercise, "case " + std::to_string(k),
             {number(k), number(1 + 0.1 * k), number(2 + 0.2 * k), number(1 / (1.0 + k))},
             result.size() == 2 ? function_of(energy_of, energy_of) : function_of(energy_of));
  return exercise;
}

/// Its probes with the student's replies.
std::vector<UnitProbe> probed(const Exercise& exercise, const Function& function) {
  std::vector<UnitProbe> probes = plan_probes(exercise);
  for (UnitProbe& probe : probes)
    for (std::size_t i : probe.case_indices)
      probe.replies.push_back(returning(function(probe_inputs(exercise, probe, i))));
  return probes;
}

struct Answer {
  std::string about;
  Formula formula;
  std::string bases;  ///< of which something is said
  Exercise exercise = energy();
  Formula second = {};  ///< of its second number
};

std::vector<Answer> answers() {
  Exercise near_zero = energy();
  for (Case& one : near_zero.cases) one.scale = {1e6};
  const Exercise two_units = energy({units::joule, units::joule * units::joule});
  Exercise two_energies = energy({units::joule, units::joule});
  two_energies.result_units.resize(1);
  return {
      {"an energy", [](D m, D v, D k, D x) { return m * v * v + k * x * x / 7; }, ""},
      {"m v", momentum_of, "unit"},
      {"m v near zero", momentum_of, "", near_zero},
      {"v²", [](D, D v, D, D) { return v * v; }, "unit"},
      {"m √m v²", [](D m, D v, D, D) { return m * std::sqrt(m) * v * v; }, "k"},
      {"m for a pure number", [](D m, D, D, D) { return m; }, "unit", energy({units::none})},
      {"an energy for its square", energy_of, "kms", two_units, energy_of},
      {"an energy and m v", energy_of, "ms", two_energies, momentum_of},
      // Of a sum of dimensions one sentence is enough; a single wrong power says more and stands alone.
      {"m v + k x²", [](D m, D v, D k, D x) { return m * v + k * x * x; }, "m"},
      {"m² v + k m x²", [](D m, D v, D k, D x) { return m * m * v + k * m * x * x; }, "k"},
      {"zero for large m", [](D m, D v, D, D) { return m > 100 ? 0.0 : m * v * v; }, "k"},
      // A sign that changes, as that of an eigenvector may, and the errors of an integration say nothing.
      {"negative for large m", [](D m, D v, D, D) { return m > 100 ? -m * v * v : m * v * v; }, ""},
      {"inexact", [](D m, D v, D, D) { return m * v * v * (1 + 0.02 * std::sin(1e4 * m + 1e3 * v)); }, ""},
  };
}

}  // namespace

TEST_CASE("Probes are the same quantities in small units, for base units of arguments, at a few deciding cases") {
  const std::vector<UnitProbe> probes = plan_probes(momentum());
  REQUIRE(probes.size() == 3);
  CHECK(std::string{probes[0].base, probes[1].base, probes[2].base} == "kms");
  for (const UnitProbe& probe : probes) CHECK(probe.case_indices == std::vector<std::size_t>{0, 3, 7});
  CHECK(plan_probes(given_results(Kind::number, {number(1)})).empty());
  const std::vector<std::vector<double>> small = {{1000, 1.1, 2200, 0.5}, {1, 110, 2.2, 50}, {1, 1.1e-3, 2.2e-6, 0.5}};
  for (std::size_t p = 0; p < 3; ++p)
    for (std::size_t a = 0; a < 4; ++a)
      CHECK(probe_inputs(energy(), probes[p], 0)[a].numbers[0] == doctest::Approx(small[p][a]).epsilon(1e-12));
}

TEST_CASE("A wrong unit is named, or what shows it in each base unit, and a right one never") {
  std::string text;
  for (const Answer& answer : answers()) {
    const Function function = function_of(answer.formula, answer.second);
    const Answers values = all_answers(outputs(answer.exercise, function));
    std::string bases;
    text += answer.about + "\n";
    for (const Reason& each : diagnose_dimensions(answer.exercise, values, probed(answer.exercise, function))) {
      CHECK(each.kind == ReasonKind::dimension);
      bases += each.name;
      text += "  " + each.sentence + "\n";
    }
    CHECK_MESSAGE(bases == answer.bases, answer.about << ": " << bases);
  }
  compare_with_golden_file("dimensions.txt", text);
}

TEST_CASE("Probes without a value say nothing, and neither do they where a misconception is named") {
  const Function wrong = function_of(momentum_of);
  const Answers values = all_answers(outputs(energy(), wrong));
  std::vector<UnitProbe> probes = probed(energy(), wrong);
  Exercise known = energy();
  add_misconception(known, "momentum", "This is the momentum.", wrong);
  CHECK(diagnose(energy(), values, probes).size() == 1);
  CHECK(diagnose(known, values, probes).size() == 1);
  for (UnitProbe& probe : probes) probe.replies[1] = ending(Ending::exception);
  CHECK(diagnose(energy(), values, probes).empty());
  for (UnitProbe& probe : probes) probe.replies.clear();
  CHECK(diagnose(energy(), values, probes).empty());
}

}  // namespace workbook::testing
