#include "checker/explain/question.hpp"

#include "checker/base/text.hpp"
#include "checker/judging/comparison.hpp"

#include <algorithm>
#include <cmath>

namespace workbook {

namespace {

/// To be told apart as they are printed, with a few digits, and not only by the sign or the order that the exercise
/// leaves free.
bool look_different(const ExerciseReference& exercise, std::size_t case_index, const Value& one, const Value& other) {
  double size = 0, difference = 0;
  for (std::size_t k = 0; k < one.numbers.size(); ++k) {
    size = std::max({size, std::abs(one.numbers[k]), std::abs(other.numbers[k])});
    difference = std::max(difference, std::abs(one.numbers[k] - other.numbers[k]));
  }
  return difference > 0.01 * size && !is_same_answer(exercise, case_index, one, other);
}

/// Misconceptions, three if there are so many, the first of which gives another value at the case than the others and
/// than a right function. @param all_fail  the others must not be right there
std::vector<std::size_t> told_apart(const ExerciseReference& exercise, std::size_t case_index, std::size_t begin,
                                    bool all_fail) {
  const std::vector<Misconception>& all = exercise.misconceptions;
  const Value& expected = exercise.cases[case_index].expected;
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < all.size() && chosen.size() < 3; ++k) {
    const std::size_t number = (begin + k) % all.size();
    if (case_index >= all[number].outputs.size()) continue;
    const Value& given = all[number].outputs[case_index];
    if (!given.has_shape_of(expected) || !given.is_finite()) continue;
    if ((all_fail || chosen.empty()) && !look_different(exercise, case_index, given, expected)) continue;
    const bool is_new =
        std::ranges::none_of(chosen, [&](std::size_t other) { return all[other].message == all[number].message; });
    if (is_new &&
        (chosen.empty() || look_different(exercise, case_index, given, all[chosen.front()].outputs[case_index])))
      chosen.push_back(number);
  }
  return chosen;
}

}  // namespace

std::optional<Question> question_on(const ExerciseReference& exercise) {
  // The easiest inputs first: those with the fewest numbers.
  std::vector<std::pair<std::size_t, std::size_t>> cases;
  for (std::size_t i = 0; i < exercise.described_cases(); ++i) {
    std::size_t numbers = 0;
    for (const Value& input : exercise.cases[i].inputs) numbers += input.numbers.size();
    cases.emplace_back(numbers, i);
  }
  std::ranges::sort(cases);
  const std::size_t chance = std::stoul(fingerprint(exercise.name).substr(0, 6), nullptr, 16);
  for (const bool all_fail : {true, false})
    for (const auto& [numbers, i] : cases)
      for (std::size_t begin = 0; begin < exercise.misconceptions.size(); ++begin) {
        std::vector<std::size_t> chosen = told_apart(exercise, i, chance + begin, all_fail);
        if (chosen.size() < 3) continue;
        const std::size_t right = chance % 3;
        std::swap(chosen[0], chosen[right]);
        return Question{i, {chosen[0], chosen[1], chosen[2]}, right};
      }
  return std::nullopt;
}

}  // namespace workbook
