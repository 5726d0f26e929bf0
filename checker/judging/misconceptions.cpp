#include "checker/judging/misconceptions.hpp"

#include "checker/judging/comparison.hpp"

#include <algorithm>

namespace workbook {

namespace {

bool fits(const ExerciseReference& exercise, const Answers& answers, const Misconception& misconception) {
  const auto deciding = deciding_cases(exercise);
  const auto agrees = [&](std::size_t i) {
    return is_same_answer(exercise, i, *answers[i], misconception.outputs.at(i));
  };
  // Where both are wrong, the agreement says something.
  const auto both_are_wrong = [&](std::size_t i) {
    return !passes(exercise, i, *answers[i]) && !passes(exercise, i, misconception.outputs.at(i));
  };
  return std::ranges::all_of(deciding, agrees) && std::ranges::any_of(deciding, both_are_wrong);
}

}  // namespace

std::optional<Diagnosis> diagnose_misconception(const ExerciseReference& exercise, const Answers& answers) {
  if (!all_deciding_cases_answered(exercise, answers)) return std::nullopt;
  std::optional<Diagnosis> named;
  for (const Misconception& misconception : exercise.misconceptions) {
    if (!fits(exercise, answers, misconception)) continue;
    if (named && named->message != misconception.message) return std::nullopt;
    if (!named) named = {DiagnosisKind::misconception, misconception.name, misconception.message, misconception.notes};
  }
  return named;
}

}  // namespace workbook
