// How much of the reasons is told at which try of a problem.
#include "checker/base/text.hpp"
#include "checker/explain/explain.hpp"

#include <algorithm>
#include <cmath>

namespace workbook {

namespace {

/// The first try at which a reason of that kind is told.
int first_stage(ReasonKind kind) {
  using enum ReasonKind;
  constexpr ReasonKind at_once[] = {code, accuracy, property, learnt};
  constexpr ReasonKind second[] = {split, independence, entry, place};
  return std::ranges::count(at_once, kind) > 0 ? 1 : std::ranges::count(second, kind) > 0 ? 2 : 3;
}

/// With which inputs the factor changes by which the result is wrong, as cases tell that differ in one of them only.
std::string inputs_of_factor(const ExerciseReference& exercise, const Answers& answers) {
  constexpr double same = 1e-6;
  if (exercise.result_kind == Kind::integer || exercise.comparison != Comparison::plain) return "";
  const auto size = [](const Value& value) {
    return value.numbers.size() == 1 ? value.numbers.front() : as_matrix(value).norm();
  };
  const auto factor = [&](std::size_t i) {
    return answers[i] ? size(*answers[i]) / size(exercise.cases[i].expected) : std::nan("");
  };
  std::vector<std::string> with, without;
  for (std::size_t a = 0; a < exercise.arguments.size(); ++a) {
    std::size_t changes = 0, pairs = 0;
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      if (exercise.cases[i].base < 0 || exercise.cases[i].argument != static_cast<int>(a)) continue;
      const double change = factor(i) / factor(static_cast<std::size_t>(exercise.cases[i].base)) - 1;
      if (!std::isfinite(change)) continue;
      changes += std::abs(change) > same ? 1 : 0;
      ++pairs;
    }
    if (pairs > 0) (changes > 0 ? with : without).push_back(exercise.arguments[a].name);
  }
  if (with.empty()) return "";
  return fmt::format(" The factor between {} and the right one changes with {}{}.",
                     exercise.result_kind == Kind::number ? "your result" : "the length of your result", listed(with),
                     without.empty() ? "" : ", not with " + listed(without));
}

}  // namespace

Reason where_it_fails(const ExerciseReference& exercise, const Answers& answers) {
  constexpr std::size_t most_named = 3;
  const Outcomes outcomes = outcomes_of(exercise, answers);
  const auto names_of = [&](const std::vector<std::size_t>& cases) {
    std::vector<std::string> names;
    for (const std::size_t index : cases)
      if (const std::string name = fmt::format("“{}”", exercise.cases[index].name);
          index < exercise.described_cases() && names.size() < most_named && std::ranges::count(names, name) == 0)
        names.push_back(name);
    return names;
  };
  const std::vector<std::string> right = names_of(outcomes.right), wrong = names_of(outcomes.wrong);
  std::string sentence = fmt::format("It is wrong at {} of {}", outcomes.wrong.size(),
                                     plural(outcomes.wrong.size() + outcomes.right.size(), "case"));
  const auto limit = std::ranges::find_if(
      exercise.limits, [&](const Limit& each) { return std::ranges::count(outcomes.wrong, each.case_index) > 0; });
  if (limit != exercise.limits.end())
    sentence += fmt::format(", the limit “{}” among them (case {}): work that one out first.",
                            exercise.cases[limit->case_index].name, limit->case_index + 1);
  else if (!wrong.empty() && wrong.size() == outcomes.wrong.size())
    sentence += " only: " + listed(wrong) + ".";
  else
    sentence += right.empty() ? "." : ", and right at " + listed(right) + ".";
  return {ReasonKind::place, "where", sentence, Weight::symptom};
}

void hold_back(std::vector<Reason>& reasons, int stage, const ExerciseReference& exercise, const Answers& answers) {
  const auto is_told = [&](const Reason& reason) {
    // An argument without effect is a region too.
    return first_stage(reason.kind) <= stage && !(stage == 1 && reason.is_remark());
  };
  if (std::erase_if(reasons, std::not_fn(is_told)) == 0 || !std::ranges::all_of(reasons, &Reason::is_remark)) return;
  if (stage > 1)
    for (Mechanism* const mechanism : {&diagnose_split, &diagnose_one_side, &diagnose_place, &diagnose_kinds})
      if (const auto region = mechanism(exercise, answers); region && is_told(*region)) {
        reasons.push_back(*region);
        return;
      }
  reasons.push_back(where_it_fails(exercise, answers));
  reasons.back().sentence += " The reason is named at the third try with a changed file, or after a hint.";
  if (stage > 1) reasons.back().sentence += inputs_of_factor(exercise, answers);
}

}  // namespace workbook
