#include "checker/judging/judge.hpp"

#include "checker/judging/answers.hpp"
#include "checker/judging/comparison.hpp"
#include "checker/judging/diagnosis.hpp"
#include "checker/messages/judging.hpp"

#include <algorithm>
#include <utility>

namespace workbook {

namespace {

using messages::Advice;

Verdict verdict_of(Refusal refusal) {
  switch (refusal) {
    case Refusal::rejected_file:
      return Verdict::rejected_file;
    case Refusal::compile_error:
      return Verdict::compile_error;
    case Refusal::missing_function:
      return Verdict::missing_function;
    case Refusal::checker_error:
      return Verdict::checker_error;
  }
  return Verdict::checker_error;
}

/// The verdict on a call that gave no value.
Verdict verdict_of(Ending ending) {
  switch (ending) {
    case Ending::returned:
      break;
    // A function that returns at other inputs has been started; what it throws is then an exception like any other.
    case Ending::not_started:
    case Ending::exception:
      return Verdict::uncaught_exception;
    case Ending::wrong_shape:
      return Verdict::wrong_shape;
    case Ending::crashed:
      return Verdict::crashed;
    case Ending::stopped_early:
      return Verdict::stopped_early;
    case Ending::time_limit:
      return Verdict::time_limit;
    case Ending::memory_limit:
      return Verdict::memory_limit;
    case Ending::output_limit:
      return Verdict::output_limit;
    case Ending::forbidden_operation:
      return Verdict::forbidden_operation;
    case Ending::protocol_violation:
      return Verdict::protocol_violation;
    case Ending::not_run:
      return Verdict::time_limit;
  }
  return Verdict::protocol_violation;
}

Verdict assess(const ExerciseReference& exercise, std::size_t case_index, const Value& actual) {
  if (!is_complete(actual)) return Verdict::protocol_violation;
  if (!actual.has_shape_of(exercise.cases[case_index].expected)) return Verdict::wrong_shape;
  if (!is_finite(actual)) return Verdict::non_finite_value;
  return passes(exercise, case_index, actual) ? Verdict::passed : Verdict::wrong_value;
}

Verdict assess(const ExerciseReference& exercise, std::size_t case_index, const std::vector<Reply>& replies) {
  if (case_index >= replies.size()) return Verdict::protocol_violation;
  const Reply& reply = replies[case_index];
  return reply.ending == Ending::returned ? assess(exercise, case_index, reply.value) : verdict_of(reply.ending);
}

Advice advice_on_failure(const ExerciseReference& exercise, std::size_t case_index, const std::vector<Reply>& replies,
                         Verdict verdict, const Judgement& judgement) {
  const Case& one = exercise.cases[case_index];
  if (case_index >= replies.size()) return messages::missing_reply(one);
  const Reply& reply = replies[case_index];
  if (reply.ending != Ending::returned) return messages::no_value(exercise, one, reply);
  switch (verdict) {
    case Verdict::protocol_violation:
      return messages::damaged_value(one);
    case Verdict::wrong_shape:
      return messages::wrong_shape(one, exercise.result_kind, reply.value);
    case Verdict::non_finite_value:
      return messages::non_finite(one, exercise.result_kind, reply.value);
    default:
      return messages::wrong_value(one, judgement.cases_passed, judgement.cases_total, !judgement.diagnoses.empty());
  }
}

void decide(Judgement& judgement, Verdict verdict, Advice advice) {
  judgement.verdict = verdict;
  judgement.message = std::move(advice.message);
  judgement.next_step = std::move(advice.next_step);
}

/// True if the repeat says the same as the first run, up to rounding. Two right answers are the same, whatever their
/// sign.
bool is_consistent(const ExerciseReference& exercise, std::size_t case_index, const Value& first, const Value& again) {
  return is_same_answer(exercise, case_index, again, first) ||
         (passes(exercise, case_index, first) && passes(exercise, case_index, again));
}

/// The repeat whose value differs from that of the first run, if there is one.
const Repeat* inconsistent_repeat(const ExerciseReference& exercise, const Observation& observation) {
  for (const Repeat& repeat : observation.repeats) {
    const std::size_t i = repeat.case_index;
    if (i >= exercise.cases.size() || i >= observation.replies.size()) continue;
    const Reply& first = observation.replies[i];
    if (!has_usable_value(first, exercise.cases[i]) || !has_usable_value(repeat.reply, exercise.cases[i])) continue;
    if (!is_consistent(exercise, i, first.value, repeat.reply.value)) return &repeat;
  }
  return nullptr;
}

void decide_inconsistent(Judgement& judgement, const ExerciseReference& exercise, const Observation& observation,
                         const Repeat& repeat) {
  const std::size_t i = repeat.case_index;
  const Value& first = observation.replies[i].value;
  decide(judgement, Verdict::inconsistent_value,
         messages::inconsistent(exercise.cases[i], exercise.result_kind, first, repeat.reply.value));
}

/// All cases have passed; the repeats may still fail.
void judge_repeats(Judgement& judgement, const ExerciseReference& exercise, const Observation& observation) {
  for (const Repeat& repeat : observation.repeats) {
    const std::size_t i = repeat.case_index;
    if (i >= exercise.cases.size()) {
      return decide(judgement, Verdict::checker_error, messages::repeat_of_no_case());
    }
    const Case& one = exercise.cases[i];
    if (repeat.reply.ending != Ending::returned) {
      return decide(judgement, verdict_of(repeat.reply.ending),
                    messages::no_value_when_repeated(exercise, one, repeat.reply));
    }
    const Verdict verdict = assess(exercise, i, repeat.reply.value);
    if (verdict == Verdict::protocol_violation) return decide(judgement, verdict, messages::damaged_value(one));
    if (verdict == Verdict::wrong_shape) {
      return decide(judgement, verdict, messages::wrong_shape(one, exercise.result_kind, repeat.reply.value));
    }
  }
  if (const Repeat* repeat = inconsistent_repeat(exercise, observation)) {
    return decide_inconsistent(judgement, exercise, observation, *repeat);
  }
  decide(judgement, Verdict::passed, messages::passed(exercise.cases.size()));
}

bool is_not_started(const ExerciseReference& exercise, const std::vector<Reply>& replies) {
  return replies.size() >= exercise.cases.size() &&
         std::ranges::all_of(replies, [](const Reply& reply) { return reply.ending == Ending::not_started; });
}

}  // namespace

Judgement judge(const ExerciseReference& exercise, const Observation& observation) {
  Judgement judgement;
  judgement.cases_total = exercise.cases.size();

  if (observation.refusal) {
    decide(judgement, verdict_of(*observation.refusal),
           messages::refused(*observation.refusal, observation.refusal_message, exercise.signature));
    return judgement;
  }
  if (exercise.cases.empty()) {
    decide(judgement, Verdict::checker_error, messages::no_cases(exercise.name));
    return judgement;
  }
  if (is_not_started(exercise, observation.replies)) {
    decide(judgement, Verdict::not_started, messages::not_started());
    return judgement;
  }

  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) verdicts.push_back(assess(exercise, i, observation.replies));
  judgement.cases_passed = static_cast<std::size_t>(std::ranges::count(verdicts, Verdict::passed));

  const auto first = std::ranges::find_if(verdicts, [](Verdict verdict) { return verdict != Verdict::passed; });
  if (first == verdicts.end()) {
    if (observation.replies.size() == exercise.cases.size()) {
      judge_repeats(judgement, exercise, observation);
    } else {
      decide(judgement, Verdict::protocol_violation,
             messages::surplus_replies(observation.replies.size(), exercise.cases.size()));
    }
    return judgement;
  }

  const auto case_index = static_cast<std::size_t>(first - verdicts.begin());
  const Answers answers = answers_of(exercise, observation.replies);
  judgement.first_failure = FirstFailure{case_index, answers[case_index]};
  if (*first == Verdict::wrong_value || *first == Verdict::non_finite_value) {
    // Random answers and variables that are never set have no other explanation.
    if (const Repeat* repeat = inconsistent_repeat(exercise, observation)) {
      decide_inconsistent(judgement, exercise, observation, *repeat);
      return judgement;
    }
    judgement.diagnoses = diagnose(exercise, answers, observation.probes);
  }
  decide(judgement, *first, advice_on_failure(exercise, case_index, observation.replies, *first, judgement));
  return judgement;
}

}  // namespace workbook
