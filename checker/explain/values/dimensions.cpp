#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"
#include "checker/judging/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace workbook {

namespace {

struct Base {
  char name;
  int Unit::*exponent;
  double factor;  ///< how many small units make one
  const char* change;
};
constexpr Base bases[] = {{'k', &Unit::kilogram, 1000.0, "With masses in g"},
                          {'m', &Unit::metre, 100.0, "With lengths in cm"},
                          {'s', &Unit::second, 1000.0, "With times in ms"}};
constexpr std::size_t probed_cases = 3;

// Powers are exact but for rounding, and for the step error of an integration; what is neither exact nor clearly off
// says nothing.
constexpr double exact_power = 1e-3;
constexpr double clearly_off = 0.05;

// A number so much smaller than the result's natural size may be a rounding error.
constexpr double safely_away_from_zero = 1e-3;

const Base& base_of(const UnitProbe& probe) { return *std::ranges::find(bases, probe.base, &Base::name); }

/// The powers p of the observed growth factor^p, one per number that can be used; nothing if a reply is missing.
/// @param number  of the result; nothing: all
std::optional<std::vector<double>> observed_powers(const ExerciseReference& exercise, const Answers& answers,
                                                   const UnitProbe& probe, std::optional<std::size_t> number) {
  std::vector<double> powers;
  for (std::size_t k = 0; k < probe.case_indices.size(); ++k) {
    const std::size_t i = probe.case_indices[k];
    if (i >= answers.size() || !answers[i] || k >= probe.replies.size()) return std::nullopt;
    const Case& one = exercise.cases[i];
    if (!has_usable_value(probe.replies[k], one)) return std::nullopt;
    for (std::size_t n = 0; n < one.expected.numbers.size(); ++n) {
      if (number && n != *number) continue;
      const double before = answers[i]->numbers[n];
      const double after = probe.replies[k].value.numbers[n];
      if (!std::isfinite(before) || !(std::abs(before) > safely_away_from_zero * scale_at(one, n))) continue;
      powers.push_back(std::log(std::abs(after / before)) / std::log(probe.factor));
    }
  }
  return powers;
}

enum class UnitFinding { nothing, single_power, no_single_power };

struct Power {
  UnitFinding finding = UnitFinding::nothing;
  double value = 0.0;
};

/// Whole and half powers are those that formulas have.
Power single_power(const std::vector<double>& powers) {
  if (powers.empty()) return {};
  const double nearest = std::round(2 * powers.front()) / 2;
  double largest_distance = 0.0;
  for (double power : powers) {
    const double distance = std::abs(power - nearest);
    // Not finite: a number became zero, infinite or NaN by the change of units.
    if (!std::isfinite(distance)) return {UnitFinding::no_single_power, 0.0};
    largest_distance = std::max(largest_distance, distance);
  }
  if (largest_distance <= exact_power) return {UnitFinding::single_power, nearest};
  return {largest_distance > clearly_off ? UnitFinding::no_single_power : UnitFinding::nothing, 0.0};
}

/// Where each number of the result has one power of its own: the first with another than the expected one.
std::optional<std::pair<std::size_t, Power>> odd_number(const ExerciseReference& exercise, const Answers& answers,
                                                        const UnitProbe& probe, double expected) {
  std::optional<std::pair<std::size_t, Power>> odd;
  for (std::size_t n = 0; n < exercise.cases[probe.case_indices.front()].expected.numbers.size(); ++n) {
    const Power power = single_power(observed_powers(exercise, answers, probe, n).value_or(std::vector<double>()));
    if (power.finding == UnitFinding::no_single_power) return std::nullopt;
    if (!odd && power.finding == UnitFinding::single_power && power.value != expected) odd = {n, power};
  }
  return odd;
}

std::string growth(double decades, const char* grow, const char* shrink, const char* unchanged) {
  const double size = std::abs(decades);
  if (size == 0) return unchanged;
  const std::string times =
      size == std::round(size) ? "10" + superscript(static_cast<int>(size)) : number_text(std::pow(10, size), 3);
  return fmt::format("{} {} times", decades > 0 ? grow : shrink, times);
}

/// "the result", or "component 2 of the result"
std::string part(const std::string& owner, const std::string& component) {
  return (component.empty() ? "" : component + " of ") + owner + " result";
}

std::string wrong_power(const Base& base, double expected_decades, double actual_decades,
                        const std::string& component) {
  return fmt::format("{} {} {}, yours {}.", base.change, part("the", component),
                     growth(expected_decades, "should grow", "should shrink", "should not change"),
                     growth(actual_decades, "grows", "shrinks", "does not change"));
}

/// "Your result has the unit kg² m⁴, and kg m² is asked for."
Reason wrong_unit(Unit actual, const ExerciseReference& exercise) {
  const auto words = [](Unit unit) { return unit == units::none ? "no unit" : "the unit " + to_string(unit); };
  Unit expected = exercise.result_units.front();
  expected.radian = 0;
  return {ReasonKind::dimension, "unit",
          fmt::format("Your result has {}, and {} is asked for.", words(actual),
                      expected == units::none ? "a pure number" : to_string(exercise.result_units.front())),
          Weight::symptom};
}

std::string no_single_power(const Base& base, const std::string& component) {
  return fmt::format(
      "{} {} grows by no single power of ten: quantities of different dimension are being added, or a "
      "number in the formula hides a unit.",
      base.change, part("your", component));
}

}  // namespace

std::vector<UnitProbe> plan_probes(const ExerciseReference& exercise) {
  std::vector<UnitProbe> probes;
  for (const Base& base : bases) {
    const auto has_dimension = [&](const Argument& argument) { return argument.unit.*base.exponent != 0; };
    if (std::ranges::any_of(exercise.arguments, has_dimension))
      probes.push_back({base.name, base.factor, evenly_spaced(deciding_cases(exercise), probed_cases), {}});
  }
  return probes;
}

std::vector<Value> probe_inputs(const ExerciseReference& exercise, const UnitProbe& probe, std::size_t case_index) {
  std::vector<Value> inputs = exercise.cases.at(case_index).inputs;
  for (std::size_t a = 0; a < inputs.size(); ++a) {
    const double growth = std::pow(probe.factor, exercise.arguments.at(a).unit.*base_of(probe).exponent);
    for (double& number : inputs[a].numbers) number *= growth;
  }
  return inputs;
}

std::vector<Reason> diagnose_dimensions(const ExerciseReference& exercise, const Answers& answers,
                                        const std::vector<UnitProbe>& probes) {
  std::vector<Reason> wrong_powers;
  std::vector<Reason> no_powers;
  Unit actual = exercise.result_units.front();  // where every base unit has one whole power
  actual.radian = 0;
  bool has_unit = exercise.result_units.size() == 1;
  for (const UnitProbe& probe : probes) {
    for (std::size_t u = 0; u < exercise.result_units.size(); ++u) {
      const Base& base = base_of(probe);
      const bool has_many_units = exercise.result_units.size() > 1;
      const auto powers = observed_powers(exercise, answers, probe, has_many_units ? std::optional(u) : std::nullopt);
      if (!powers) {
        has_unit = false;
        break;
      }
      const double expected = exercise.result_units[u].*base.exponent;
      Power observed = single_power(*powers);
      const int decades = static_cast<int>(std::lround(std::log10(probe.factor)));
      auto number = has_many_units ? std::optional(u) : std::nullopt;
      if (!has_many_units && observed.finding == UnitFinding::no_single_power)
        if (const auto odd = odd_number(exercise, answers, probe, expected)) std::tie(number, observed) = *odd;
      has_unit = has_unit && !number && observed.finding == UnitFinding::single_power &&
                 observed.value == std::trunc(observed.value);
      actual.*base.exponent = static_cast<int>(observed.value);
      const Value& result = exercise.cases[probe.case_indices.front()].expected;
      const std::string component = number ? entry_name(result, exercise.result_kind, *number) : "";
      if (observed.finding == UnitFinding::single_power && observed.value != expected) {
        wrong_powers.push_back({ReasonKind::dimension, std::string(1, probe.base),
                                wrong_power(base, expected * decades, observed.value * decades, component),
                                Weight::symptom});
        break;
      }
      if (observed.finding == UnitFinding::no_single_power) {
        no_powers.push_back(
            {ReasonKind::dimension, std::string(1, probe.base), no_single_power(base, component), Weight::symptom});
        break;
      }
    }
  }
  if (!wrong_powers.empty() && has_unit) return {wrong_unit(actual, exercise)};
  if (!wrong_powers.empty()) return wrong_powers;
  if (no_powers.size() > 1) no_powers.resize(1);
  return no_powers;
}

}  // namespace workbook
