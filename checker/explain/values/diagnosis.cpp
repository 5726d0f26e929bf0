#include "checker/explain/values/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace workbook {

namespace {

/// Nearly right at every case: by what it differs, if that is certain, or to how many digits it is right.
std::optional<Reason> diagnose_nearly_right(const ExerciseReference& exercise, const Answers& answers) {
  const auto accuracy = diagnose_accuracy(exercise, answers);
  const auto difference = accuracy ? diagnose_difference(exercise, answers) : std::nullopt;
  return difference ? difference : accuracy;
}

/// What is wrong beside numbers that are right to a few digits only, as those of an integration in large steps.
std::optional<Reason> diagnose_coarsely(const ExerciseReference& whole, const Answers& answers) {
  constexpr std::pair<double, const char*> accuracies[] = {{1e-4, "four"}, {1e-3, "three"}, {1e-2, "two"}};
  constexpr std::size_t fewest = 5;
  ExerciseReference exercise = whole;
  for (const auto& [coarse, digits] : accuracies) {
    // What is nearly right has no other mistake.
    for (Case& one : exercise.cases) one.tolerance = std::max(one.tolerance, clear_margin * coarse);
    if (outcomes_of(exercise, answers).wrong.size() < fewest) return std::nullopt;
    for (std::size_t i = 0; i < exercise.cases.size(); ++i)
      exercise.cases[i].tolerance = std::max(whole.cases[i].tolerance, coarse);
    for (const auto& mechanism :
         {diagnose_misconception, diagnose_transform, diagnose_input_transform, diagnose_whole_turns}) {
      std::optional<Reason> found = mechanism(exercise, answers);
      // Of all inputs that may be exchanged or changed some agree by accident with two digits.
      if (!found || (coarse == 1e-2 && found->kind == ReasonKind::input_transform)) continue;
      found->sentence += fmt::format(" (Your numbers agree with those of this mistake to about {} digits.)", digits);
      return found;
    }
  }
  return std::nullopt;
}

/// What else is told beside what a mechanism finds.
enum class Beside {
  nothing,   ///< it says all
  place,     ///< where it is wrong
  symptoms,  ///< and which properties are
};

/// A new mechanism is a line here. The first that finds something is the reason.
// clang-format off
constexpr struct {
  Mechanism* look;
  Beside beside;
} mechanisms[] = {
    {diagnose_range, Beside::nothing},
    {diagnose_misconception, Beside::nothing},
    {diagnose_terms, Beside::nothing},
    {diagnose_transform, Beside::nothing},
    {diagnose_number, Beside::nothing},
    {diagnose_input_transform, Beside::nothing},
    {diagnose_factor, Beside::nothing},
    {diagnose_whole_turns, Beside::nothing},
    {diagnose_one_term, Beside::nothing},
    {diagnose_wrong_part, Beside::nothing},
    {diagnose_places, Beside::nothing},
    {diagnose_nearly_right, Beside::nothing},
    {diagnose_coarsely, Beside::nothing},
    {diagnose_eigenvectors, Beside::nothing},
    {diagnose_difference, Beside::nothing},
    {diagnose_along, Beside::nothing},
    {diagnose_split, Beside::place},
    {diagnose_conditional, Beside::place},
    {diagnose_both_mistakes, Beside::nothing},
    {diagnose_signs, Beside::nothing},
    {diagnose_some_part, Beside::nothing},
    {diagnose_one_entry, Beside::nothing},
    {diagnose_kinds, Beside::place},
    {diagnose_no_effect, Beside::nothing},
    {diagnose_threshold, Beside::symptoms},
    {diagnose_one_side, Beside::symptoms},
    {diagnose_mostly_near, Beside::symptoms},
};
// clang-format on

}  // namespace

std::vector<Reason> diagnose(const ExerciseReference& exercise, const Answers& answers) {
  std::vector<Reason> reasons;
  Beside beside = Beside::symptoms;
  for (const auto& mechanism : mechanisms) {
    const auto found = mechanism.look(exercise, answers);
    if (!found) continue;
    reasons = {*found};
    beside = mechanism.beside;
    break;
  }
  if (beside == Beside::symptoms) {
    std::ranges::move(diagnose_properties(exercise, answers), std::back_inserter(reasons));
    if (std::ranges::any_of(reasons, &Reason::is_cause)) return reasons;
  }
  if (beside != Beside::nothing)
    if (const auto place = diagnose_place(exercise, answers)) reasons.push_back(*place);
  return reasons;
}

}  // namespace workbook
