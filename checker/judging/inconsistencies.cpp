#include "checker/judging/inconsistencies.hpp"

#include "checker/judging/answers.hpp"
#include "checker/judging/comparison.hpp"
#include "checker/judging/judge.hpp"
#include "checker/judging/properties.hpp"
#include "checker/judging/terms.hpp"
#include "checker/messages/workbook_in_order.hpp"

#include <algorithm>
#include <cmath>

namespace workbook {

namespace {

using Sentences = std::vector<std::string>;

constexpr std::size_t fewest_misconceptions = 3;
constexpr std::size_t fewest_routes = 3;
constexpr std::size_t fewest_deciding_cases = 6;

/// What would be seen of a student who gives these values.
Judgement judge_values(const ExerciseReference& exercise, const std::vector<Value>& values) {
  Observation observation;
  for (const Value& value : values) {
    Reply reply;
    reply.ending = Ending::returned;
    reply.value = value;
    observation.replies.push_back(std::move(reply));
  }
  return judge(exercise, observation);
}

std::vector<Value> expected_values(const ExerciseReference& exercise) {
  std::vector<Value> values;
  for (const Case& one : exercise.cases) values.push_back(one.expected);
  return values;
}

void check_parts(const ExerciseReference& exercise, Sentences& found) {
  const std::size_t deciding = deciding_cases(exercise).size();
  if (exercise.misconceptions.size() < fewest_misconceptions) {
    found.push_back(messages::few_misconceptions(exercise.misconceptions.size(), fewest_misconceptions));
  }
  if (exercise.routes.size() < fewest_routes) {
    found.push_back(messages::few_routes(exercise.routes.size(), fewest_routes));
  }
  if (deciding < fewest_deciding_cases) {
    found.push_back(messages::few_deciding_cases(deciding, fewest_deciding_cases));
  }
  if (std::ranges::find(exercise.cases, Group::worked, &Case::group) == exercise.cases.end()) {
    found.push_back(messages::no_worked_case());
  }
  if (exercise.sweep.x.empty()) found.push_back(messages::no_sweep());
}

void check_expected(const ExerciseReference& exercise, Sentences& found) {
  if (const Judgement judgement = judge_values(exercise, expected_values(exercise)); !judgement.passed()) {
    found.push_back(messages::expected_values_fail(judgement.message));
  }
  for (const Property& property : exercise.properties) {
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      if (!clearly_lacks(exercise, property, i, exercise.cases[i].expected)) continue;
      found.push_back(
          messages::expected_value_lacks(exercise.cases[i].name, to_string(property.kind),
                                         violation(exercise, property, i, exercise.cases[i].expected).detail));
    }
  }
}

bool is_right_at_deciding_cases(const ExerciseReference& exercise, const Misconception& misconception) {
  return std::ranges::all_of(deciding_cases(exercise),
                             [&](std::size_t i) { return passes(exercise, i, misconception.outputs.at(i)); });
}

bool cannot_be_told_apart(const ExerciseReference& exercise, const Misconception& one, const Misconception& other) {
  return std::ranges::all_of(deciding_cases(exercise), [&](std::size_t i) {
    return is_same_answer(exercise, i, one.outputs.at(i), other.outputs.at(i));
  });
}

void check_misconceptions(const ExerciseReference& exercise, Sentences& found) {
  const auto& misconceptions = exercise.misconceptions;
  for (auto one = misconceptions.begin(); one != misconceptions.end(); ++one) {
    if (is_right_at_deciding_cases(exercise, *one)) {
      found.push_back(messages::misconception_is_right(one->name));
      continue;
    }
    bool has_twin = false;
    for (auto other = misconceptions.begin(); other != misconceptions.end(); ++other) {
      if (one == other || one->message == other->message || !cannot_be_told_apart(exercise, *one, *other)) continue;
      has_twin = true;
      if (one < other) {
        found.push_back(messages::misconceptions_cannot_be_told_apart(one->name, other->name));
      }
    }
    if (has_twin) continue;

    const Judgement judgement = judge_values(exercise, one->outputs);
    if (judgement.diagnoses.size() == 1 && judgement.diagnoses.front().message == one->message) continue;
    found.push_back(messages::misconception_is_not_named(
        one->name, judgement.diagnoses.empty() ? judgement.message : judgement.diagnoses.front().message));
  }
}

/// Σ coefficient × term at one case.
Value sum_of_terms(const ExerciseReference& exercise, std::size_t case_index) {
  Value sum = exercise.cases[case_index].expected;
  std::ranges::fill(sum.numbers, 0.0);
  for (const Term& term : exercise.terms) {
    for (std::size_t n = 0; n < sum.numbers.size(); ++n) {
      sum.numbers[n] += term.coefficient * term.outputs.at(case_index).numbers.at(n);
    }
  }
  return sum;
}

void check_terms(const ExerciseReference& exercise, Sentences& found) {
  if (exercise.terms.empty()) return;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (passes(exercise, i, sum_of_terms(exercise, i))) continue;
    found.push_back(messages::terms_do_not_add_up(exercise.cases[i].name));
  }
  const std::vector<Value> expected = expected_values(exercise);
  if (!determine_coefficients(term_equations(exercise, Answers(expected.begin(), expected.end())))) {
    found.push_back(messages::terms_are_not_independent());
  }
}

void check_routes(const ExerciseReference& exercise, Sentences& found) {
  for (const Route& route : exercise.routes) {
    const Judgement judgement = judge_values(exercise, route.outputs);
    if (judgement.passed()) continue;
    found.push_back(messages::route_fails(route.name, judgement.message));
  }
}

}  // namespace

Sentences inconsistencies(const ExerciseReference& exercise) {
  Sentences found;
  check_parts(exercise, found);
  check_expected(exercise, found);
  check_misconceptions(exercise, found);
  check_terms(exercise, found);
  check_routes(exercise, found);
  return found;
}

}  // namespace workbook
