#include "checker/judging/judge.hpp"

#include "checker/base/text.hpp"
#include "checker/judging/comparison.hpp"
#include "checker/judging/run_failures.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace workbook {

namespace {

constexpr std::pair<Verdict, const char*> verdict_names[] = {{Verdict::passed, "passed"},
                                                             {Verdict::wrong_value, "wrong_value"},
                                                             {Verdict::non_finite_value, "non_finite_value"},
                                                             {Verdict::wrong_shape, "wrong_shape"},
                                                             {Verdict::not_started, "not_started"},
                                                             {Verdict::waiting, "waiting"},
                                                             {Verdict::compile_error, "compile_error"},
                                                             {Verdict::missing_function, "missing_function"},
                                                             {Verdict::uncaught_exception, "uncaught_exception"},
                                                             {Verdict::crashed, "crashed"},
                                                             {Verdict::stopped_early, "stopped_early"},
                                                             {Verdict::time_limit, "time_limit"},
                                                             {Verdict::memory_limit, "memory_limit"},
                                                             {Verdict::output_limit, "output_limit"},
                                                             {Verdict::forbidden_operation, "forbidden_operation"},
                                                             {Verdict::protocol_violation, "protocol_violation"},
                                                             {Verdict::inconsistent_value, "inconsistent_value"},
                                                             {Verdict::rejected_file, "rejected_file"},
                                                             {Verdict::checker_error, "checker_error"}};

const char* const only_the_function =
    "Let the file hold the function and its helpers only, and let it return its result.";

std::string at(const Case& one) { return fmt::format("at the case “{}”", one.name); }

/// On a call that gave no value. A function that returns at other inputs has been started; what it throws is then an
/// exception like any other.
Verdict verdict_of(Ending ending) {
  using enum Verdict;
  switch (ending) {
    case Ending::not_started:
    case Ending::exception:
      return uncaught_exception;
    case Ending::wrong_shape:
      return wrong_shape;
    case Ending::crashed:
      return crashed;
    case Ending::stopped_early:
      return stopped_early;
    case Ending::not_run:
    case Ending::time_limit:
      return time_limit;
    case Ending::memory_limit:
      return memory_limit;
    case Ending::output_limit:
      return output_limit;
    case Ending::forbidden_operation:
      return forbidden_operation;
    case Ending::returned:
    case Ending::protocol_violation:
      break;
  }
  return protocol_violation;
}

/// The shape in the words of the kind.
std::string shape(Kind kind, const Value& value) {
  const auto rows = static_cast<std::size_t>(std::max(value.rows, 0));
  const auto cols = static_cast<std::size_t>(std::max(value.cols, 0));
  if (kind == Kind::vector && value.cols == 1) return plural(rows, "component");
  if (kind == Kind::points && value.rows == 3) return plural(cols, "column");
  if (kind == Kind::matrices && value.rows == 3 && cols % 3 == 0) return plural(cols / 3, "matrix", "matrices");
  return fmt::format("the shape {}×{}", value.rows, value.cols);
}

Advice wrong_shape(const Case& one, const std::string& when, Kind kind, const Value& actual) {
  return {fmt::format("The result has {} {}, expected {}.", shape(kind, actual), when, shape(kind, one.expected)),
          "Give the result its size from the sizes of the arguments before you fill it."};
}

Advice non_finite(const Case& one, Kind kind, const Value& actual) {
  const auto found = std::ranges::find_if(actual.numbers, [](double number) { return !std::isfinite(number); });
  const std::string entry = entry_name(actual, kind, static_cast<std::size_t>(found - actual.numbers.begin()));
  return {
      fmt::format("{} is {} {}.", capitalized(entry), std::isnan(*found) ? "not a number (NaN)" : "infinite", at(one)),
      "Look for a division by zero, the root of a negative number, an acos beyond 1, or an entry that is never set."};
}

Verdict assess(const ExerciseReference& exercise, std::size_t case_index, const Reply& reply) {
  if (reply.ending != Ending::returned) return verdict_of(reply.ending);
  const Value& actual = reply.value;
  if (!actual.is_complete()) return Verdict::protocol_violation;
  if (!actual.has_shape_of(exercise.cases[case_index].expected)) return Verdict::wrong_shape;
  if (!actual.is_finite()) return Verdict::non_finite_value;
  return passes(exercise, case_index, actual) ? Verdict::passed : Verdict::wrong_value;
}

/// What to say of a reply that did not pass.
Advice advice_on(const ExerciseReference& exercise, std::size_t case_index, const std::string& when, const Reply& reply,
                 Verdict verdict, const Judgement& judgement) {
  const Case& one = exercise.cases[case_index];
  if (verdict == Verdict::wrong_shape) return wrong_shape(one, when, exercise.result_kind, reply.value);
  if (reply.ending != Ending::returned) return advice_on_ending(when, reply, exercise.signature);
  if (verdict == Verdict::non_finite_value) return non_finite(one, exercise.result_kind, reply.value);
  if (verdict == Verdict::protocol_violation)
    return {fmt::format("The reply {} does not hold as many numbers as its shape says.", when), only_the_function};
  return {fmt::format("The value is wrong at {} of {}, first {}.", judgement.failing.size(),
                      plural(judgement.cases_total, "case"), when),
          "Compare your value with the expected one, and work this case out by hand."};
}

void decide(Judgement& judgement, Verdict verdict, Advice advice) {
  judgement.verdict = verdict;
  judgement.message = std::move(advice.message);
  judgement.next_step = std::move(advice.next_step);
}

Advice refused(Refusal refusal, const std::string& message, const std::string& signature) {
  const auto message_or = [&](const char* usual) { return message.empty() ? usual : message; };
  switch (refusal) {
    case Refusal::rejected_file:
      return {message_or("The file cannot be taken as an exercise."),
              "Check that it is the right file, plain C++ text and not empty."};
    case Refusal::compile_error:
      return {message_or("The file does not compile."),
              "Fix the first error that the compiler shows; the later ones often follow from it."};
    case Refusal::missing_function:
      return {message_or("The file compiles, but the function of the exercise is not in it."),
              "Keep name and parameters as the header declares them, in namespace rigid: " + signature + "."};
    case Refusal::checker_error:
      break;
  }
  return {message_or("Something went wrong in the checker."),
          fmt::format("This is not your fault and costs no points: run `{}`, and tell your instructor if it stays.",
                      command("doctor"))};
}

Verdict verdict_of(Refusal refusal) {
  using enum Verdict;
  constexpr std::array verdicts = {rejected_file, compile_error, missing_function, checker_error};
  return verdicts.at(static_cast<std::size_t>(refusal));
}

/// The repeat whose value differs from that of the first run by more than rounding, if there is one, or of which one
/// passes and one does not. Two right answers agree, whatever their sign.
const Repeat* inconsistent_repeat(const ExerciseReference& exercise, const Observation& observation) {
  for (const Repeat& repeat : observation.repeats) {
    const std::size_t i = repeat.case_index;
    if (i >= exercise.cases.size() || i >= observation.replies.size()) continue;
    const Reply& first = observation.replies[i];
    const Case& one = exercise.cases[i];
    if (!has_usable_value(first, one) || !has_usable_value(repeat.reply, one)) continue;
    const bool passes_first = passes(exercise, i, first.value);
    const bool passes_again = passes(exercise, i, repeat.reply.value);
    if (passes_first && passes_again) continue;
    if (passes_first || passes_again || !is_same_answer(exercise, i, repeat.reply.value, first.value)) return &repeat;
  }
  return nullptr;
}

void decide_inconsistent(Judgement& judgement, const ExerciseReference& exercise, const Observation& observation,
                         const Repeat& repeat) {
  const std::size_t i = repeat.case_index;
  const Value& first = observation.replies[i].value;
  const Value& again = repeat.reply.value;
  const auto difference = [&](std::size_t n) {
    const double one = first.numbers[n], other = again.numbers[n];
    if (std::isfinite(one) && std::isfinite(other)) return std::abs(one - other) / scale_at(exercise.cases[i], n);
    return std::isfinite(one) == std::isfinite(other) ? 0.0 : std::numeric_limits<double>::infinity();
  };
  std::size_t n = 0;
  for (std::size_t k = 1; k < first.numbers.size(); ++k) n = difference(k) > difference(n) ? k : n;
  const auto [once, later] = distinct_texts(first.numbers[n], again.numbers[n], 6);
  decide(judgement, Verdict::inconsistent_value,
         {fmt::format("The same input gave two results {}: {} was {} at first and {} when run again.",
                      at(exercise.cases[i]), entry_name(first, exercise.result_kind, n), once, later),
          "Let the result depend on the arguments alone: look for static variables, random numbers, the clock, or "
          "variables that are never set."});
  std::erase(judgement.failing, i);
  judgement.failing.insert(judgement.failing.begin(), i);  // the case that the sentence names is the one to show
}

/// All cases have passed; the repeats may still fail.
void judge_repeats(Judgement& judgement, const ExerciseReference& exercise, const Observation& observation) {
  for (const auto& [i, reply] : observation.repeats) {
    if (i >= exercise.cases.size())
      return decide(judgement, Verdict::checker_error,
                    refused(Refusal::checker_error, "A case was repeated that does not exist.", ""));
    const Verdict verdict = assess(exercise, i, reply);
    if (verdict == Verdict::passed || verdict == Verdict::wrong_value || verdict == Verdict::non_finite_value) continue;
    judgement.failing = {i};
    const std::string when = fmt::format("when the case “{}” was run once more", exercise.cases[i].name);
    return decide(judgement, verdict, advice_on(exercise, i, when, reply, verdict, judgement));
  }
  if (const Repeat* repeat = inconsistent_repeat(exercise, observation))
    return decide_inconsistent(judgement, exercise, observation, *repeat);
  decide(judgement, Verdict::passed,
         {judgement.cases_total == 1 ? "The one case agrees with the reference."
                                     : fmt::format("All {} cases agree with the reference.", judgement.cases_total),
          "Go on to the next exercise, or read in the notes what to try next."});
}

/// @param verdict  of the first case that has not passed
void decide_failed(Judgement& judgement, const ExerciseReference& exercise, const Observation& observation,
                   Verdict verdict) {
  const std::size_t first = judgement.failing.front();
  const Repeat* const repeat = verdict == Verdict::wrong_value || verdict == Verdict::non_finite_value
                                   ? inconsistent_repeat(exercise, observation)
                                   : nullptr;
  const std::string when = at(exercise.cases[first]);
  if (repeat != nullptr) {  // random answers and variables that are never set have no other explanation
    decide_inconsistent(judgement, exercise, observation, *repeat);
  } else if (first < observation.replies.size()) {
    decide(judgement, verdict, advice_on(exercise, first, when, observation.replies[first], verdict, judgement));
  } else {
    decide(judgement, verdict,
           {fmt::format("No reply came back {}.", when),
            "Check that the function returns at every input and does not end the program."});
  }
}

bool is_not_started(const ExerciseReference& exercise, const std::vector<Reply>& replies) {
  return replies.size() >= exercise.cases.size() &&
         std::ranges::all_of(replies, [](const Reply& reply) { return reply.ending == Ending::not_started; });
}

}  // namespace

std::string to_string(Verdict verdict) {
  return std::ranges::find(verdict_names, verdict, &std::pair<Verdict, const char*>::first)->second;
}

void to_json(nlohmann::json& document, const Verdict& verdict) { document = to_string(verdict); }

void from_json(const nlohmann::json& document, Verdict& verdict) {
  const auto found = std::ranges::find_if(verdict_names, [&](const auto& entry) { return document == entry.second; });
  verdict = found == std::end(verdict_names) ? Verdict::checker_error : found->first;
}

std::string in_words(std::string verdict) {
  std::ranges::replace(verdict, '_', ' ');
  return verdict;
}

Judgement judge(const ExerciseReference& exercise, const Observation& observation) {
  const std::vector<Reply>& replies = observation.replies;
  const bool has_run = !observation.refusal && !exercise.cases.empty();
  const bool is_started = has_run && !is_not_started(exercise, replies);
  Judgement judgement;
  judgement.cases_total = exercise.cases.size();
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    verdicts.push_back(is_started && i < replies.size() ? assess(exercise, i, replies[i])
                                                        : Verdict::protocol_violation);
    if (verdicts.back() != Verdict::passed) judgement.failing.push_back(i);
  }
  if (!has_run) {
    const Refusal refusal = observation.refusal.value_or(Refusal::checker_error);
    const std::string message = observation.refusal
                                    ? observation.refusal_message
                                    : fmt::format("The reference results hold no cases for {}.", exercise.name);
    decide(judgement, verdict_of(refusal), refused(refusal, message, exercise.signature));
  } else if (!is_started) {
    decide(judgement, Verdict::not_started,
           {"You have not started this exercise: the TODO is still there.",
            "Open the file, replace the TODO by your formula, and check again."});
  } else if (!judgement.failing.empty()) {
    decide_failed(judgement, exercise, observation, verdicts[judgement.failing.front()]);
  } else if (replies.size() == exercise.cases.size()) {
    judge_repeats(judgement, exercise, observation);
  } else {
    decide(
        judgement, Verdict::protocol_violation,
        {fmt::format("There were {} replies to {} calls.", replies.size(), exercise.cases.size()), only_the_function});
  }
  return judgement;
}

std::vector<std::size_t> evenly_spaced(const std::vector<std::size_t>& items, std::size_t count) {
  if (items.size() <= count) return items;
  if (count == 1) return {items.front()};
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < count; ++k) chosen.push_back(items[k * (items.size() - 1) / (count - 1)]);
  return chosen;
}

std::vector<PlannedCall> plan_calls(const std::vector<Case>& cases) {
  std::vector<PlannedCall> calls;
  for (const Case& one : cases) calls.push_back({one.inputs, one.expected.rows, one.expected.cols});
  return calls;
}

std::vector<std::size_t> plan_repeats(const ExerciseReference& exercise) {
  std::vector<std::size_t> all(exercise.cases.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::size_t> chosen = evenly_spaced(all, 3);
  std::ranges::reverse(chosen);
  return chosen;
}

}  // namespace workbook
