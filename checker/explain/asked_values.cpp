// What values tell, with further calls of the function where they are needed to be sure.
#include "checker/base/text.hpp"
#include "checker/explain/explainers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace workbook {

namespace {

/// The points of the plot as cases, and the answers there: those that the plot is drawn from, if it is drawn.
struct Plot {
  std::vector<Case> points;
  Answers answers;
};

Plot plot_of(const Evidence& evidence) {
  const ExerciseReference& exercise = evidence.task.reference;
  const Sweep& sweep = exercise.sweep;
  Plot plot;
  std::vector<PlannedCall> calls;
  double size = 0;
  for (std::size_t i = 0; i < sweep.x.size(); ++i) {
    const Value& expected = sweep.expected[i];
    Case& point = plot.points.emplace_back(exercise.cases.front());
    point.inputs = sweep.inputs[i];
    point.expected = expected;
    calls.push_back({point.inputs, expected.rows, expected.cols});
    size = std::max(size, as_matrix(expected).cwiseAbs().maxCoeff());
  }
  for (Case& point : plot.points) point.scale = {size};
  std::vector<Reply> replies = evidence.task.observation.sweep;
  if (replies.empty() && !calls.empty()) replies = evidence.ask(calls);
  plot.answers.resize(calls.size());
  for (std::size_t i = 0; i < replies.size(); ++i)
    if (has_usable_value(replies[i], plot.points[i])) plot.answers[i] = replies[i].value;
  return plot;
}

/// Does what tells wrong cases from right ones also tell the points of the plot from each other? By coincidence of the
/// cases it would not.
bool is_confirmed(const Reason& split, const Plot& plot, ExerciseReference exercise, Answers answers) {
  const auto claim = [](const std::string& message) { return message.substr(0, message.find(" (")); };
  const std::size_t judged = exercise.cases.size();
  exercise.properties.clear();  // whose weights are those of cases
  for (std::size_t i = 0; i < plot.points.size(); ++i) {
    if (!plot.answers[i]) continue;
    for (Region& each : exercise.regions) each.holds[exercise.cases.size()] = each.holds[judged + i];
    exercise.cases.push_back(plot.points[i]);
    answers.push_back(plot.answers[i]);
  }
  const std::optional<Reason> again = diagnose_split(exercise, answers);
  return again && claim(again->sentence) == claim(split.sentence);
}

/// Why finite values are wrong, where others are not finite: one cause of the former is not silenced by the latter.
/// Empty where values that are finite are right, or too few, or where nothing is certain.
std::vector<Reason> diagnose_finite(ExerciseReference exercise, Answers answers) {
  std::size_t finite = 0, wrong = 0;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (answers[i] && answers[i]->is_finite()) {
      ++finite;
      wrong += passes(exercise, i, *answers[i]) ? 0 : 1;
    } else {
      exercise.cases[i].deciding = false;
      answers[i].reset();
    }
  }
  constexpr std::size_t fewest = 3;
  if (2 * finite < exercise.cases.size() || wrong < fewest) return {};
  std::vector<Reason> found;
  if (4 * wrong >= finite)
    found = diagnose(exercise, answers);
  else if (const auto misconception = diagnose_misconception(exercise, answers))
    found = {*misconception};
  if (std::ranges::none_of(found, &Reason::is_cause)) found.clear();
  return found;
}

/// With which elements of a list the result never changes, although the right one does: further calls tell.
std::optional<Reason> elements_without_effect(const Ask& ask, const ExerciseReference& reference,
                                              const Answers& answers) {
  struct Pattern {
    const char* words;
    bool (*has_effect)(std::size_t element, std::size_t count);
  };
  static constexpr Pattern patterns[] = {
      {"any entry of {} but the first", [](std::size_t k, std::size_t) { return k == 0; }},
      {"any entry of {} but the first two", [](std::size_t k, std::size_t) { return k < 2; }},
      {"any entry of {} but the last", [](std::size_t k, std::size_t n) { return k + 1 == n; }},
      {"any entry of {} but the first and the last", [](std::size_t k, std::size_t n) { return k == 0 || k + 1 == n; }},
      {"the first entry of {}", [](std::size_t k, std::size_t) { return k > 0; }},
      {"the last entry of {}", [](std::size_t k, std::size_t n) { return k + 1 < n; }}};
  constexpr std::size_t fewest = 3, most = 40, most_cases = 3;
  for (std::size_t a = 0; a < reference.arguments.size(); ++a) {
    const auto columns = [&](std::size_t i) -> std::size_t {
      const Value& list = reference.cases[i].inputs[a];
      const Kind kind = reference.arguments[a].kind;
      return kind == Kind::vector     ? list.numbers.size()
             : kind == Kind::points   ? static_cast<std::size_t>(list.cols)
             : kind == Kind::matrices ? static_cast<std::size_t>(list.cols) / 3
                                      : 0;
    };
    std::vector<Pattern> fitting(std::begin(patterns), std::end(patterns));
    std::size_t looked_at = 0;
    for (std::size_t i = 0; i < reference.described_cases() && looked_at < most_cases; ++i) {
      const Case& one = reference.cases[i];
      const std::size_t count = columns(i), stride = count > 0 ? one.inputs[a].numbers.size() / count : 0;
      if (count < fewest || count > most || !answers[i] || passes(reference, i, *answers[i]) ||
          std::ranges::count(one.inputs[a].numbers, 0) > 0)  // what is 0 stays so
        continue;
      ++looked_at;
      std::vector<PlannedCall> calls(count, {one.inputs, one.expected.rows, one.expected.cols});
      for (std::size_t k = 0; k < count * stride; ++k) calls[k / stride].inputs[a].numbers[k] *= 1.01;
      const std::vector<Reply> replies = ask(calls);
      std::erase_if(fitting, [&](const Pattern& pattern) {
        for (std::size_t k = 0; k < count; ++k) {
          const bool is_same = replies[k].ending == Ending::returned && replies[k].value.numbers == answers[i]->numbers;
          if (is_same == pattern.has_effect(k, count)) return true;
        }
        return false;
      });
    }
    const auto right_one_changes = [&](const Case& changed) {
      if (changed.base < 0 || changed.argument != static_cast<int>(a)) return false;
      const auto base = static_cast<std::size_t>(changed.base);
      return !is_same_answer(reference, base, changed.expected, reference.cases[base].expected);
    };
    if (looked_at > 0 && !fitting.empty() && std::ranges::any_of(reference.cases, right_one_changes))
      return Reason{ReasonKind::independence, "elements",
                    fmt::format("Your result never changes with {}; the right one does.",
                                fmt::format(fmt::runtime(fitting.front().words), reference.arguments[a].name)),
                    Weight::symptom};
  }
  return std::nullopt;
}

}  // namespace

bool are_zero(const Answers& answers) {
  return std::ranges::all_of(answers, [](const std::optional<Value>& answer) {
    return answer && std::ranges::all_of(answer->numbers, [](double number) { return number == 0; });
  });
}

bool explain_values(Search& search) {
  const Evidence& evidence = search.evidence;
  const ExerciseReference& reference = evidence.task.reference;
  const bool are_finite = search.verdict() == Verdict::wrong_value;
  search.reasons = are_finite ? diagnose(reference, search.answers) : diagnose_finite(reference, search.answers);
  if (!are_finite && search.reasons.empty())
    if (const auto split = diagnose_split(reference, search.answers)) search.reasons = {*split};
  std::erase_if(search.reasons, [&](const Reason& reason) {
    return reason.kind == ReasonKind::split && reason.is_cause() &&
           !is_confirmed(reason, plot_of(evidence), reference, search.answers);
  });
  if (!search.has_cause()) return false;
  if (are_finite) return true;
  std::vector<Reason> besides = diagnostic_run(evidence.task, evidence.toolchain, evidence.cache);
  for (Reason& reason : besides) reason.sentence = "Besides, at the cases without a finite number: " + reason.sentence;
  search.add_code(std::move(besides));
  return true;
}

bool explain_lost_digits(Search& search) {
  constexpr double nearly_right = 1e-5, telling_part = 0.1;
  constexpr std::size_t most_cases = 6, tries = 8;
  const ExerciseReference& reference = search.evidence.task.reference;
  Outcomes outcome = outcomes_of(reference, search.answers);
  const auto error_of = [&](std::size_t index, const Value& value) {
    double error = 0;
    for (const Deviation& each : deviations(reference, index, value)) error = std::max(error, each.relative_size());
    return error;
  };
  const std::size_t wrong = outcome.wrong.size();
  std::vector<std::size_t> near = outcome.wrong;
  std::erase_if(near, [&](std::size_t index) { return !(error_of(index, *search.answers[index]) <= nearly_right); });
  const bool are_near = !near.empty() && 2 * near.size() >= wrong;
  if (outcome.wrong.empty()) return false;
  if (are_near) outcome.wrong = near;
  const std::vector<std::size_t> looked_at = evenly_spaced(outcome.wrong, most_cases);
  std::size_t jumping = 0;
  for (const std::size_t index : looked_at) {
    const Case& one = reference.cases[index];
    std::vector<PlannedCall> calls(tries, {one.inputs, one.expected.rows, one.expected.cols});
    std::size_t count = 0;  // each number is moved otherwise
    for (std::size_t k = 0; k < calls.size(); ++k)
      for (std::size_t a = 0; a < one.inputs.size(); ++a) {
        if (reference.arguments[a].kind == Kind::integer) continue;
        for (double& number : calls[k].inputs[a].numbers)
          number *= 1 + (static_cast<double>((++count * (2 * k + 3)) % 7) - 3) * std::numeric_limits<double>::epsilon();
      }
    std::vector<double> errors = {error_of(index, *search.answers[index])};
    for (const Reply& reply : search.evidence.ask(calls)) {
      if (!has_usable_value(reply, one) || !reply.value.is_finite()) return false;
      errors.push_back(error_of(index, reply.value));
    }
    const double most = std::ranges::max(errors), span = most - std::ranges::min(errors);
    const bool jumps = span > one.tolerance && span > telling_part * most;
    std::set<long> levels;
    for (const double error : errors) levels.insert(std::lround(error / (telling_part * most)));
    // At the edge of a wrong branch there are two.
    if (!are_near && !(jumps && levels.size() > 2)) return false;
    jumping += jumps ? 1 : 0;
  }
  if (jumping == 0 || 2 * jumping < looked_at.size()) return false;
  search.reasons = {
      {ReasonKind::accuracy, "lost_digits",
       fmt::format("{} your result is wrong {} digits are chance: they change when an input changes in its 16th digit. "
                   "Digits are lost in a difference of nearly equal numbers, or in acos and asin near ±1, where atan2 "
                   "keeps them.",
                   std::cmp_equal(outcome.wrong.size(), wrong)
                       ? "Where"
                       : fmt::format("At {} of the {} where", outcome.wrong.size(), plural(wrong, "case")),
                   are_near ? "it is nearly right, but its last" : "its")}};
  return true;
}

bool explain_growing_error(Search& search) {
  constexpr double no_rounding = 1e3, most = 0.3, twice = 1.9, nearly_twice = 2.7, nearly_whole = 0.1;
  const ExerciseReference& reference = search.evidence.task.reference;
  const Sweep& sweep = reference.sweep;
  const auto is_along = [&](std::size_t a) {
    for (std::size_t i = 0; i < sweep.x.size(); ++i)
      if (sweep.inputs[i][a].numbers != std::vector{sweep.x[i]}) return false;
    return !sweep.x.empty();
  };
  std::size_t along = 0;
  while (along < reference.arguments.size() && !is_along(along)) ++along;
  if (search.has_cause() || along == reference.arguments.size()) return false;
  const Plot plot = plot_of(search.evidence);
  ExerciseReference exercise = reference;
  exercise.cases = plot.points;
  exercise.properties.clear();
  std::vector<std::pair<double, double>> law;  // x, and the error there, at about twice the x before each time
  for (std::size_t i = 0; i < sweep.x.size() && law.size() < 3; ++i) {
    if (!(sweep.x[i] > 0)) continue;
    if (!plot.answers[i] || !plot.answers[i]->is_finite()) return false;
    double error = 0;
    for (const Deviation& each : deviations(exercise, i, *plot.answers[i]))
      error = std::max(error, each.relative_size() / plot.points[i].tolerance);
    if (law.empty() ? error > no_rounding : sweep.x[i] >= twice * law.back().first) law.emplace_back(sweep.x[i], error);
  }
  if (law.size() < 3 || law[2].first > nearly_twice * nearly_twice * law[0].first) return false;
  const auto slope = [&](std::size_t k) {
    return std::log(law[k + 1].second / law[k].second) / std::log(law[k + 1].first / law[k].first);
  };
  // What comes with the next power is half as much at half the x.
  const double near_zero = 2 * slope(0) - slope(1), power = std::round(near_zero);
  if (!(power >= 1 && std::abs(near_zero - power) < nearly_whole && std::abs(slope(0) - power) < most)) return false;
  const std::string& name = reference.arguments[along].name;
  const auto to_the = [&](double exponent) {
    return exponent == 1 ? name : name + superscript(static_cast<int>(exponent));
  };
  search.reasons.insert(
      search.reasons.begin(),
      {ReasonKind::accuracy, "growing_error",
       fmt::format("At the inputs of the plot your result is right in the limit {0} → 0, and its error grows with {1}: "
                   "{2} is right, and what is wrong or missing enters with {1}.",
                   name, to_the(power),
                   power == 1 ? "what it is at " + name + " = 0" : "all up to " + to_the(power - 1)),
       Weight::symptom});
  return false;
}

bool explain_elements_without_effect(Search& search) {
  if (are_zero(search.answers)) return true;
  if (const auto found = elements_without_effect(search.evidence.ask, search.evidence.task.reference, search.answers))
    search.reasons.insert(search.reasons.begin(), *found);
  return false;
}

}  // namespace workbook
