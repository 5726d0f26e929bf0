// One number of a result by itself.
#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"

#include <utility>

namespace workbook {

namespace {

Value entry_of(const Value& value, std::size_t entry) {
  Value number = value;
  number.rows = number.cols = 1;
  number.numbers = {value.numbers.at(entry)};
  return number;
}

/// The exercise, and answers to it, as if one number of its result were all of it.
ExerciseReference of_entry(const ExerciseReference& exercise, std::size_t entry) {
  ExerciseReference alone = exercise;
  alone.result_kind = Kind::number;
  if (alone.result_units.size() > 1) alone.result_units = {exercise.result_units.at(entry)};
  for (Case& one : alone.cases) {
    one.expected = entry_of(one.expected, entry);
    if (one.scale.size() > 1) one.scale = {one.scale.at(entry)};
  }
  for (Value& expected : alone.sweep.expected) expected = entry_of(expected, entry);
  alone.misconceptions.clear();
  alone.input_transforms.clear();
  alone.terms.clear();
  alone.properties.clear();
  alone.routes.clear();
  return alone;
}

Answers of_entry(const Answers& answers, std::size_t entry) {
  Answers alone = answers;
  for (std::optional<Value>& answer : alone)
    if (answer) answer = entry_of(*answer, entry);
  return alone;
}

/// "Your result …" said of one number of it.
std::string said_of_entry(const std::string& sentence, const std::string& entry) {
  constexpr std::string_view whole = "Your result";
  const bool is_subject = sentence.starts_with(whole);
  return replaced(
      is_subject ? capitalized(entry) + sentence.substr(whole.size()) : fmt::format("Of {} alone: {}", entry, sentence),
      "[Yy]our result", "it");
}

}  // namespace

std::optional<Reason> diagnose_one_entry(const ExerciseReference& exercise, const Answers& answers) {
  const std::set<std::size_t> wrong = wrong_entries(exercise, answers);
  const Value& shape = exercise.cases.front().expected;
  if (exercise.comparison != Comparison::plain || shape.numbers.size() < 2) return std::nullopt;
  for (const std::size_t entry : wrong) {
    const ExerciseReference alone = of_entry(exercise, entry);
    const Answers numbers = of_entry(answers, entry);
    for (const auto& mechanism : {diagnose_factor, diagnose_difference}) {
      std::optional<Reason> found = mechanism(alone, numbers);
      if (!found) continue;
      found->sentence = said_of_entry(found->sentence, entry_name(shape, exercise.result_kind, entry));
      found->weight = Weight::possible;
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace workbook
