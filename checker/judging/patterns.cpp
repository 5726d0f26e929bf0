// Where an answer is wrong, and what that has in common: cases, components, inputs.
#include "checker/base/text.hpp"
#include "checker/judging/diagnosis.hpp"
#include "checker/judging/quantities.hpp"
#include "checker/judging/value_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <set>

namespace workbook {

namespace {

/// The cases with an answer, and whether it is right there.
struct Outcome {
  std::vector<std::size_t> right;
  std::vector<std::size_t> wrong;
};

Outcome outcome_of(const ExerciseReference& exercise, const Answers& answers) {
  Outcome outcome;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (!answers[i]) continue;
    (passes(exercise, i, *answers[i]) ? outcome.right : outcome.wrong).push_back(i);
  }
  return outcome;
}

/// The numbers of the result that are wrong at some case; empty where entries are not compared one by one or the shape
/// differs from case to case.
std::set<std::size_t> wrong_entries(const ExerciseReference& exercise, const Answers& answers) {
  std::set<std::size_t> wrong;
  const Value& shape = exercise.cases.front().expected;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (!exercise.cases[i].expected.has_shape_of(shape)) return {};
    if (!answers[i]) continue;
    const Deviation deviation = deviations(exercise, i, *answers[i]).front();
    if (!deviation.is_entrywise) return {};
    for (std::size_t n = 0; n < shape.numbers.size(); ++n) {
      if (!deviation.is_within(n)) wrong.insert(n);
    }
  }
  return wrong;
}

std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

// --- features of a case that may decide

struct Feature {
  std::string words;        ///< to follow "wrong exactly where": "theta < 0"
  std::vector<bool> holds;  ///< per case
};

Feature feature(std::string words, const Quantity& quantity, const std::function<bool(double)>& test) {
  Feature made{std::move(words), {}};
  for (const double value : quantity.values) made.holds.push_back(test(value));
  return made;
}

std::vector<Feature> features_of(const ExerciseReference& exercise) {
  std::vector<Feature> features;
  const std::vector<Quantity> quantities = quantities_of(exercise);
  const std::size_t cases = exercise.cases.size();
  for (const Quantity& q : quantities) {
    features.push_back(feature(q.name + " = 0", q, [](double value) { return value == 0; }));
    features.push_back(feature(q.name + " < 0", q, [](double value) { return value < 0; }));
    features.push_back(feature(q.name + " > 0", q, [](double value) { return value > 0; }));
    if (!q.is_angle()) continue;
    const auto pi = std::numbers::pi;
    features.push_back(feature("|" + q.name + "| > π/2", q, [pi](double value) { return std::abs(value) > pi / 2; }));
    features.push_back(feature("|" + q.name + "| > π", q, [pi](double value) { return std::abs(value) > pi; }));
    features.push_back(feature("sin(" + q.name + ") < 0", q, [](double value) { return std::sin(value) < 0; }));
    features.push_back(feature("cos(" + q.name + ") < 0", q, [](double value) { return std::cos(value) < 0; }));
    features.push_back(
        feature("sin(" + q.name + ") = 0", q, [](double value) { return std::abs(std::sin(value)) < 1e-12; }));
  }
  for (std::size_t a = 0; a < quantities.size(); ++a) {
    for (std::size_t b = a + 1; b < quantities.size(); ++b) {
      const Quantity& one = quantities[a];
      const Quantity& other = quantities[b];
      if (!(one.unit == other.unit) || one.unit == units::none || one.is_angle()) continue;
      Feature equal{one.name + " = " + other.name, {}};
      Feature less{one.name + " < " + other.name, {}};
      Feature more{one.name + " > " + other.name, {}};
      for (std::size_t i = 0; i < cases; ++i) {
        const double x = one.values[i], y = other.values[i];
        equal.holds.push_back(std::abs(x - y) <= 1e-12 * std::max(std::abs(x), std::abs(y)));
        less.holds.push_back(x < y && !equal.holds.back());
        more.holds.push_back(x > y && !equal.holds.back());
      }
      for (Feature* each : {&equal, &less, &more}) features.push_back(std::move(*each));
    }
  }
  for (std::size_t a = 0; a < exercise.arguments.size(); ++a) {
    const Argument& argument = exercise.arguments[a];
    if (argument.kind != Kind::vector && argument.kind != Kind::points) continue;
    const auto count = [&](std::size_t i) {
      const Value& value = exercise.cases[i].inputs[a];
      return argument.kind == Kind::points ? value.cols : value.rows;
    };
    for (const int size : {0, 1}) {
      Feature few{fmt::format("{} has {}", argument.name, size == 0 ? "no entry" : "one entry only"), {}};
      for (std::size_t i = 0; i < cases; ++i) few.holds.push_back(count(i) == size);
      features.push_back(std::move(few));
    }
  }
  return features;
}

}  // namespace

std::optional<Diagnosis> diagnose_place(const ExerciseReference& exercise, const Answers& answers) {
  const std::set<std::size_t> wrong = wrong_entries(exercise, answers);
  const Value& shape = exercise.cases.front().expected;
  const Outcome outcome = outcome_of(exercise, answers);
  if (wrong.empty() || wrong.size() == shape.numbers.size() || wrong.size() > 4) return std::nullopt;
  std::vector<std::string> names;
  for (const std::size_t n : wrong) names.push_back(entry_name(shape, exercise.result_kind, n));
  const std::string where = outcome.right.empty() && outcome.wrong.size() == 1 ? "at the only case"
                            : outcome.right.empty()
                                ? fmt::format("at all {}", plural(outcome.wrong.size(), "case"))
                                : fmt::format("at {} of {}", outcome.wrong.size(),
                                              plural(outcome.right.size() + outcome.wrong.size(), "case"));
  return Diagnosis{DiagnosisKind::place, "place",
                   fmt::format("Only {} {} wrong, {}; all other numbers are right everywhere.", listed(names),
                               wrong.size() == 1 ? "is" : "are", where),
                   ""};
}

std::optional<Diagnosis> diagnose_split(const ExerciseReference& exercise, const Answers& answers) {
  const Outcome outcome = outcome_of(exercise, answers);
  constexpr std::size_t fewest = 2;
  constexpr std::size_t fewest_right = 4;
  if (outcome.wrong.size() < fewest || outcome.right.size() < fewest_right) return std::nullopt;
  std::vector<const Feature*> exact;
  const std::vector<Feature> features = features_of(exercise);
  for (const Feature& each : features) {
    const auto holds = [&](std::size_t i) { return each.holds[i]; };
    if (std::ranges::all_of(outcome.wrong, holds) && std::ranges::none_of(outcome.right, holds)) exact.push_back(&each);
  }
  if (exact.size() != 1) return std::nullopt;  // of several that fit none is certain
  return Diagnosis{DiagnosisKind::split, "split",
                   fmt::format("Yours is wrong exactly where {} ({} of {}), and right elsewhere.", exact.front()->words,
                               outcome.wrong.size(), plural(outcome.right.size() + outcome.wrong.size(), "case")),
                   ""};
}

std::optional<Diagnosis> diagnose_conditional(const ExerciseReference& exercise, const Answers& answers) {
  const Outcome outcome = outcome_of(exercise, answers);
  std::vector<std::size_t> wrong = outcome.wrong;
  std::erase_if(wrong, [&](std::size_t i) { return i >= exercise.described_cases(); });
  if (wrong.size() < 2 || outcome.right.empty()) return std::nullopt;
  std::optional<Diagnosis> named;
  for (const Misconception& each : exercise.misconceptions) {
    const bool fits = std::ranges::all_of(wrong, [&](std::size_t i) {
      return !passes(exercise, i, each.outputs[i]) && is_same_answer(exercise, i, *answers[i], each.outputs[i]);
    });
    if (!fits) continue;
    if (named && named->message != each.message) return std::nullopt;
    named = Diagnosis{DiagnosisKind::misconception, each.name,
                      fmt::format("At the cases where yours is wrong, and only there: {}", each.message), each.notes};
  }
  return named;
}

std::optional<Diagnosis> diagnose_independence(const ExerciseReference& exercise, const Answers& answers) {
  struct Change {
    std::set<int> bases;  // near one of them alone the result may well be constant
    bool moves_yours = false;
    bool moves_right = false;
  };
  std::map<std::pair<int, int>, Change> changes;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    const Case& one = exercise.cases[i];
    if (one.base < 0 || one.argument < 0) continue;
    const auto base = static_cast<std::size_t>(one.base);
    const auto has_number = [&](std::size_t k) { return answers.at(k) && answers[k]->is_finite(); };
    if (!has_number(i) || !has_number(base)) continue;
    Change& change = changes[{one.argument, one.entry}];
    change.bases.insert(one.base);
    change.moves_yours = change.moves_yours || !is_same_answer(exercise, i, *answers[i], *answers[base]);
    change.moves_right =
        change.moves_right || !is_same_answer(exercise, i, one.expected, exercise.cases[base].expected);
  }
  std::vector<std::string> names;
  for (const auto& [place, change] : changes) {
    if (change.bases.size() < 2 || change.moves_yours || !change.moves_right) continue;
    const Argument& argument = exercise.arguments[static_cast<std::size_t>(place.first)];
    const bool whole_is_named =
        changes.contains({place.first, -1}) && place.second >= 0 && !changes.at({place.first, -1}).moves_yours;
    if (!whole_is_named)
      names.push_back(argument.name +
                      (place.second < 0 ? "" : entry_suffix(argument.kind, static_cast<std::size_t>(place.second))));
  }
  if (names.empty() || names.size() > 3) return std::nullopt;
  return Diagnosis{DiagnosisKind::independence, "independence",
                   fmt::format("Your result never changes with {}; the right one does.", listed(names)), ""};
}

std::optional<Diagnosis> diagnose_entries(const ExerciseReference& exercise, const Answers& answers) {
  const std::set<std::size_t> wrong = wrong_entries(exercise, answers);
  const Value& shape = exercise.cases.front().expected;
  if (wrong.empty() || wrong.size() == shape.numbers.size()) return std::nullopt;
  const std::vector<std::size_t> deciding = deciding_cases(exercise);
  if (!all_deciding_cases_answered(exercise, answers) || deciding.size() < 3) return std::nullopt;
  const auto is_entry = [&](std::size_t i, std::size_t n, double value) {
    const Case& one = exercise.cases[i];
    return std::abs(answers[i]->numbers[n] - value) <= one.tolerance * std::max(scale_at(one, n), std::abs(value));
  };
  // What is right, or zero, where it decides explains nothing.
  const auto is_wrong_where_it_decides = [&](std::size_t n) {
    return std::ranges::any_of(deciding,
                               [&](std::size_t i) { return !is_entry(i, n, exercise.cases[i].expected.numbers[n]); });
  };
  if (!std::ranges::all_of(wrong, is_wrong_where_it_decides)) return std::nullopt;
  const auto is_zero = [&](std::size_t n) {
    return std::ranges::all_of(deciding, [&](std::size_t i) { return exercise.cases[i].expected.numbers[n] == 0; });
  };
  // An entry that holds what belongs in another one.
  std::vector<std::string> moved;
  for (const std::size_t n : wrong) {
    for (std::size_t from = 0; from < shape.numbers.size(); ++from) {
      if (from == n || is_zero(from) || !std::ranges::all_of(deciding, [&](std::size_t i) {
            return is_entry(i, n, exercise.cases[i].expected.numbers[from]);
          }))
        continue;
      moved.push_back(fmt::format("{} holds what belongs in {}", entry_name(shape, exercise.result_kind, n),
                                  entry_name(shape, exercise.result_kind, from)));
      break;
    }
  }
  if (moved.size() == wrong.size() && moved.size() <= 3)
    return Diagnosis{DiagnosisKind::entry, "moved_entry", capitalized(listed(moved)) + ".", ""};
  // The wrong entries as one misconception, or one changed input, would give them.
  std::optional<Diagnosis> named;
  const auto consider = [&](const std::vector<Value>& outputs, const Diagnosis& diagnosis) {
    const bool fits = std::ranges::all_of(deciding, [&](std::size_t i) {
      return std::ranges::all_of(wrong, [&](std::size_t n) { return is_entry(i, n, outputs[i].numbers[n]); });
    });
    if (fits && named && named->message != diagnosis.message) named->name.clear();
    if (fits && !named) named = diagnosis;
  };
  std::vector<std::string> names;
  for (const std::size_t n : wrong) names.push_back(entry_name(shape, exercise.result_kind, n));
  const std::string where = capitalized(listed(names));
  for (const Misconception& each : exercise.misconceptions)
    consider(each.outputs, {DiagnosisKind::entry, each.name, fmt::format("{}: {}", where, each.message), each.notes});
  if (named && named->name.empty()) return std::nullopt;
  return named;
}

}  // namespace workbook
