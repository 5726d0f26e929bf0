// Laws that an error follows.
#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"

#include <algorithm>
#include <cmath>

namespace workbook {

namespace {

/// A pure number that a series may be made in.
struct Candidate {
  std::string name;
  std::vector<double> values;  ///< per case
};

bool is_pure(Unit unit) { return unit.kilogram == 0 && unit.metre == 0 && unit.second == 0; }

std::vector<Candidate> candidates(const ExerciseReference& exercise) {
  struct Size {
    std::string name;
    Unit unit;
    std::vector<double> values;
  };
  std::vector<Size> sizes;
  for (const Quantity& each : quantities_of(exercise)) {
    sizes.push_back({each.name, each.unit, each.values});
    for (double& value : sizes.back().values) value = std::abs(value);
  }
  for (std::size_t a = 0; a < exercise.arguments.size(); ++a) {
    if (exercise.arguments[a].kind != Kind::vector3 && exercise.arguments[a].kind != Kind::vector2) continue;
    sizes.push_back({"|" + exercise.arguments[a].name + "|", exercise.arguments[a].unit, {}});
    for (const Case& one : exercise.cases) sizes.back().values.push_back(as_matrix(one.inputs[a]).norm());
  }
  std::vector<Candidate> found;
  for (std::size_t one = 0; one < sizes.size(); ++one) {
    if (is_pure(sizes[one].unit)) found.push_back({sizes[one].name, sizes[one].values});
    for (std::size_t other = one + 1; other < sizes.size(); ++other) {
      const bool is_product = is_pure(sizes[one].unit * sizes[other].unit);
      if (is_pure(sizes[one].unit) || is_pure(sizes[other].unit) ||
          (!is_product && !is_pure(sizes[one].unit / sizes[other].unit)))
        continue;
      Candidate both{sizes[one].name + (is_product ? "·" : "/") + sizes[other].name, sizes[one].values};
      for (std::size_t i = 0; i < both.values.size(); ++i)
        both.values[i] = is_product ? both.values[i] * sizes[other].values[i] : both.values[i] / sizes[other].values[i];
      found.push_back(std::move(both));
    }
  }
  return found;
}

}  // namespace

std::optional<Reason> diagnose_small_argument(const ExerciseReference& exercise, const Answers& answers) {
  constexpr std::size_t fewest = 12;
  constexpr double least = 1e-8, large = 0.3, range = 8, rise = 30, same_argument = 1e-6, same_error = 1e-3;
  if (exercise.comparison != Comparison::plain || exercise.result_kind == Kind::integer) return std::nullopt;
  std::vector<std::pair<std::size_t, double>> errors;  // relative
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (!answers[i] || !answers[i]->is_finite()) return std::nullopt;
    const auto right = as_matrix(exercise.cases[i].expected);
    if (right.size() == 0 || right.norm() == 0) continue;
    const double error = (as_matrix(*answers[i]) - right).norm() / right.norm();
    if (error > least && !passes(exercise, i, *answers[i])) errors.emplace_back(i, error);
  }
  if (errors.size() < fewest) return std::nullopt;
  std::optional<Reason> found;
  for (const Candidate& each : candidates(exercise)) {
    const auto argument = [&](const std::pair<std::size_t, double>& error) { return each.values[error.first]; };
    std::vector<std::pair<std::size_t, double>> ordered = errors;
    std::ranges::stable_sort(ordered, {}, argument);
    const double first = argument(ordered.front()), last = argument(ordered.back());
    if (!std::isfinite(last) || !(first > 0) || last < range * first ||
        ordered.back().second < rise * ordered.front().second)
      continue;
    std::size_t steps = 0;
    bool is_law = true, rises = true;  // until little is right any more
    for (std::size_t k = 1; k < ordered.size() && is_law; ++k) {
      const double x = argument(ordered[k - 1]), y = argument(ordered[k]);
      const double one = ordered[k - 1].second, other = ordered[k].second;
      const bool is_same = y - x <= same_argument * y;
      rises = rises && (is_same || other >= one);
      steps += rises && !is_same ? 1 : 0;
      is_law = is_same ? std::abs(other - one) <= same_error * other : other >= one || one > large;
    }
    if (!is_law || steps + 1 < fewest) continue;
    if (found) return std::nullopt;  // of two laws none is certain
    found =
        Reason{ReasonKind::difference, "small_argument",
               fmt::format("Your relative error is a function of {0} alone, from {1} at {0} = {2} to {3} at {0} = {4}: "
                           "your formula holds only where {0} is small.",
                           each.name, number_text(ordered.front().second, 2), number_text(first, 2),
                           number_text(ordered.back().second, 2), number_text(last, 2))};
  }
  return found;
}

}  // namespace workbook
