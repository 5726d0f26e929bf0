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
  for (Mechanism* const mechanism : {&diagnose_split, &diagnose_threshold, &diagnose_one_side})
    if (!are_finite && search.reasons.empty())
      if (const auto found = mechanism(reference, search.answers)) search.reasons = {*found};
  const std::size_t unconfirmed = std::erase_if(search.reasons, [&](const Reason& reason) {
    return reason.kind == ReasonKind::split && reason.is_cause() &&
           !is_confirmed(reason, plot_of(evidence), reference, search.answers);
  });
  if (unconfirmed > 0)  // what is not exactly so may still be so of all wrong cases
    if (const auto found = diagnose_one_side(reference, search.answers)) search.reasons.push_back(*found);
  if (!search.has_cause()) return false;
  if (are_finite) return true;
  std::vector<Reason> besides = diagnostic_run(evidence.task, evidence.toolchain, evidence.cache);
  for (Reason& reason : besides) {
    reason.sentence = "At the cases without a finite number: " + reason.sentence;
    reason.weight = Weight::symptom;
  }
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
  const bool are_angles = reference.result_units == std::vector{units::radian};
  std::vector<std::size_t> near = outcome.wrong;
  bool may_be_branch = false;  // where angles are near, but wrong by as much as they are
  std::erase_if(near, [&](std::size_t index) {
    const Value &right = reference.cases[index].expected, &given = *search.answers[index];
    if (error_of(index, given) <= nearly_right) return false;
    const bool is_near_angle = are_angles && given.has_shape_of(right) &&
                               (as_matrix(given) - as_matrix(right)).cwiseAbs().maxCoeff() <= nearly_right;
    may_be_branch = may_be_branch || is_near_angle;
    return !is_near_angle;
  });
  const bool are_near = !near.empty() && 2 * near.size() >= wrong;
  if (outcome.wrong.empty()) return false;
  if (are_near) outcome.wrong = near;
  const SourceText source(search.evidence.task.submission.text);
  const bool has_atan2 = std::ranges::count(source.tokens(), "atan2", &Token::text) > 0;
  // acos(-1) is π.
  const auto arc = std::ranges::find_if(source.tokens(), [&](const Token& token) {
    const std::size_t behind = token.offset + token.text.size();
    return is_one_of(token.text, {"acos", "asin"}) &&
           !workbook::search(source.text().substr(behind), R"(^\s*\(\s*-?[\d.]+\s*\))");
  });
  const auto end = source.tokens().end();
  const auto tell_arc = [&] {
    if (arc == end) return false;
    search.add_code({source.reason(
        source.place_of(arc->offset), "lost_digits",
        fmt::format("{} loses half of the digits of an angle where its argument is near 1 "
                    "or −1, and your result is wrong by so little{}: atan2 keeps them.",
                    arc->text,
                    near.size() < wrong ? fmt::format(" at {} of {}", near.size(), plural(wrong, "wrong case")) : ""),
        Weight::possible)});
    return true;
  };
  if (are_near && may_be_branch && tell_arc()) return false;
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
    if ((!are_near || may_be_branch) && !(jumps && levels.size() > 2)) return false;
    jumping += jumps ? 1 : 0;
  }
  // Of a result that is 0 or π there, no digit changes by chance.
  if (are_near && near.size() == wrong && 2 * jumping < looked_at.size() && tell_arc()) return false;
  if (jumping == 0 || 2 * jumping < looked_at.size()) return false;
  search.reasons = {
      {ReasonKind::accuracy, "lost_digits",
       fmt::format("{} your result is wrong {} digits are chance: they change when an input changes in its 16th digit. "
                   "Digits are lost in a difference of nearly equal numbers{}{}.",
                   std::cmp_equal(outcome.wrong.size(), wrong)
                       ? "Where"
                       : fmt::format("At {} of the {} where", outcome.wrong.size(), plural(wrong, "case")),
                   are_near ? "it is nearly right, but its last" : "its",
                   arc == end ? "" : ", or in acos and asin near ±1, where atan2 keeps them",
                   has_atan2 ? ", or in atan2 where both its arguments are nearly 0" : "")}};
  return true;
}

}  // namespace workbook
