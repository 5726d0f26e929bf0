#include "checker/explain/values/soundness.hpp"

#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"
#include "checker/judging/judge.hpp"

#include <algorithm>
#include <cmath>

namespace workbook {

namespace {

using Sentences = std::vector<std::string>;

constexpr std::size_t fewest_misconceptions = 3;
constexpr std::size_t fewest_routes = 3;
constexpr std::size_t fewest_deciding_cases = 6;

/// The verdict on a student who gives these values.
Judgement judge_values(const ExerciseReference& exercise, const std::vector<Value>& values) {
  Observation observation;
  for (const Value& value : values) observation.replies.push_back({.ending = Ending::returned, .value = value});
  return judge(exercise, observation);
}

std::vector<Value> expected_values(const ExerciseReference& exercise) {
  std::vector<Value> values;
  for (const Case& one : exercise.cases) values.push_back(one.expected);
  return values;
}

void check_parts(const ExerciseReference& exercise, Sentences& found) {
  const auto require = [&](std::size_t count, std::size_t fewest, const std::string& what) {
    if (count < fewest) found.push_back(fmt::format("It has {}, fewer than {}.", plural(count, what), fewest));
  };
  require(exercise.misconceptions.size(), fewest_misconceptions, "misconception");
  require(exercise.routes.size(), fewest_routes, "route");
  require(deciding_cases(exercise).size(), fewest_deciding_cases, "deciding case");
  require(static_cast<std::size_t>(std::ranges::count(exercise.cases, Group::worked, &Case::group)), 1, "worked case");
  require(exercise.sweep.x.size(), 2, "sweep point");
}

void check_conditions(const ExerciseReference& exercise, Sentences& found) {
  constexpr double most = 0.25;
  for (const Case& one : exercise.cases)
    if (one.condition > most)
      found.push_back(
          fmt::format("Rounding of the inputs alone takes {:.2g} of the tolerance of the case “{}”: no answer "
                      "in double precision is sure to pass.",
                      one.condition, one.name));
}

void check_expected(const ExerciseReference& exercise, Sentences& found) {
  if (const Judgement judgement = judge_values(exercise, expected_values(exercise)); !judgement.passed()) {
    found.push_back("The expected values do not pass: " + judgement.message);
  }
  for (const Property& property : exercise.properties) {
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      if (!clearly_lacks(exercise, property, i, exercise.cases[i].expected)) continue;
      found.push_back(fmt::format("The expected value of the case “{}” is not {}: {}.", exercise.cases[i].name,
                                  to_string(property.kind),
                                  violation(exercise, property, i, exercise.cases[i].expected).detail));
    }
  }
}

void check_misconceptions(const ExerciseReference& exercise, Sentences& found) {
  const auto& misconceptions = exercise.misconceptions;
  const std::vector<std::size_t> deciding = deciding_cases(exercise);
  for (auto one = misconceptions.begin(); one != misconceptions.end(); ++one) {
    const auto is_right = [&](std::size_t i) { return passes(exercise, i, one->outputs.at(i)); };
    if (std::ranges::all_of(deciding, is_right)) {
      found.push_back(fmt::format("The misconception {} is right at all deciding cases.", one->name));
      continue;
    }
    bool has_twin = false;
    for (auto other = misconceptions.begin(); other != misconceptions.end(); ++other) {
      const auto is_same = [&](std::size_t i) {
        return is_same_answer(exercise, i, one->outputs.at(i), other->outputs.at(i));
      };
      if (one == other || one->message == other->message || !std::ranges::all_of(deciding, is_same)) continue;
      has_twin = true;
      if (one < other) {
        found.push_back(fmt::format(
            "The misconceptions {} and {} have different messages but cannot be told apart at the deciding cases.",
            one->name, other->name));
      }
    }
    if (has_twin) continue;

    const std::vector<Value>& outputs = one->outputs;
    const auto diagnoses = diagnose(exercise, Answers(outputs.begin(), outputs.end()));
    if (diagnoses.size() == 1 && diagnoses.front().sentence == one->message) continue;
    found.push_back(fmt::format("The misconception {} is not named when a student has it: {}", one->name,
                                diagnoses.empty() ? "nothing is said." : diagnoses.front().sentence));
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
    found.push_back(
        fmt::format("The terms do not add up to the expected value at the case “{}”.", exercise.cases[i].name));
  }
  const std::vector<Value> expected = expected_values(exercise);
  if (!term_equations(exercise, Answers(expected.begin(), expected.end())).determine_coefficients()) {
    found.push_back("The terms are not independent at the deciding cases.");
  }
}

void check_routes(const ExerciseReference& exercise, Sentences& found) {
  for (const Route& route : exercise.routes) {
    const Judgement judgement = judge_values(exercise, route.outputs);
    if (judgement.passed()) continue;
    found.push_back(fmt::format("The route “{}” does not pass: {}", route.name, judgement.message));
  }
}

/// Generated cases carry no outputs of wrong answers, terms and routes.
ExerciseReference without_generated_cases(ExerciseReference exercise) {
  const std::size_t described = exercise.described_cases();
  exercise.cases.resize(described);
  for (Property& property : exercise.properties) property.weights.resize(std::min(described, property.weights.size()));
  return exercise;
}

}  // namespace

bool do_routes_agree_on_another(const ExerciseReference& whole) {
  const ExerciseReference exercise = without_generated_cases(whole);
  const std::vector<Route>& routes = exercise.routes;
  const auto passes_judge = [&](const Route& route) { return judge_values(exercise, route.outputs).passed(); };
  if (routes.size() < 2 || std::ranges::any_of(routes, passes_judge)) return false;
  return std::ranges::all_of(routes, [&](const Route& route) {
    for (std::size_t i = 0; i < exercise.cases.size(); ++i)
      if (!is_same_answer(exercise, i, route.outputs.at(i), routes.front().outputs.at(i))) return false;
    return true;
  });
}

Sentences unsound_parts(const ExerciseReference& exercise) {
  const ExerciseReference described = without_generated_cases(exercise);
  if (do_routes_agree_on_another(exercise))
    return {fmt::format("All {} routes agree with each other, and not with the solution: correct that first.",
                        described.routes.size())};
  Sentences found;
  check_parts(described, found);
  check_conditions(exercise, found);
  check_expected(exercise, found);
  check_misconceptions(described, found);
  check_terms(described, found);
  check_routes(described, found);
  std::ranges::move(unshown_bugs(exercise, exercise.adequacy.survivors), std::back_inserter(found));
  if (!exercise.has_current_adequacy)
    found.push_back(
        fmt::format("What its cases find of typical bugs is not on record, or was recorded for other cases: "
                    "`{}` tries it and records it.",
                    command("self-check --record " + exercise.name)));
  return found;
}

Sentences unshown_bugs(const ExerciseReference& exercise, const Sentences& survivors) {
  Sentences found;
  for (const std::string& bug : survivors) {
    if (exercise.survivor_reason(bug).empty())
      found.push_back(fmt::format("No case shows the bug “{}”: add one, or say with survivor(...) why none can.", bug));
  }
  return found;
}

}  // namespace workbook
