// The verdict on everything that can be seen of a student's function; its wording is in golden/verdicts.txt.
#include "checker/data/reason.hpp"
#include "checker/judging/judge.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <set>

namespace workbook::testing {
namespace {

using V = Verdict;
using E = Ending;
using Cases = std::vector<std::size_t>;

const Cases all_nine = {0, 1, 2, 3, 4, 5, 6, 7, 8};

Observation right() { return observed(outputs(momentum(), right_momentum)); }

/// Right at all other cases, or as it was.
Observation at(std::size_t case_index, const Reply& reply, Observation observation = right()) {
  observation.replies[case_index] = reply;
  return observation;
}

Observation again(std::size_t case_index, const Reply& reply, Observation observation = right()) {
  observation.repeats.push_back({case_index, reply});
  return observation;
}

Observation not_started(std::size_t count) {
  Observation observation;
  observation.replies.assign(count, ending(E::not_started));
  return observation;
}

Observation refused(Refusal refusal, const std::string& message = "") {
  Observation observation = right();
  observation.refusal = refusal;
  observation.refusal_message = message;
  return observation;
}

Reply crashed_with(int signal, CrashCause cause = CrashCause::unknown) {
  Reply reply = ending(E::crashed);
  reply.signal = signal;
  reply.cause = cause;
  return reply;
}
Reply forbidden(long system_call) {
  Reply reply = ending(E::forbidden_operation);
  reply.system_call = system_call;
  return reply;
}
Reply of_shape(int rows, int cols) { return {E::wrong_shape, {rows, cols, {}}}; }
Reply three(double x, double y, double z) { return returning(vector({x, y, z})); }

struct Judged {
  std::string about;
  V verdict;
  Cases failing;
  Observation observation;
  Exercise exercise = momentum();
};

constexpr double nan = not_a_number;
const Observation two_wrong = at(2, three(1, 2, 3), at(3, three(4, 5, 6)));
const Value two_points = three_rows({{1, 2}, {1, 2}, {1, 2}});
const Exercise twice_two_points = given_results(Kind::points, {two_points, two_points});
const Exercise points = given_results(Kind::points, {two_points});
const Exercise quaternion = given_results(Kind::vector, {vector({1})}, Comparison::up_to_sign);
const Exercise list = given_results(Kind::vector, {vector({1, 2, 3})});
const Exercise matrices = given_results(Kind::matrices, {diagonal(1, 1, 1)});
const Exercise no_cases = given_results(Kind::number, {});

const std::vector<Judged> of_all_replies = {
    {"right", V::passed, {}, right()},
    {"right at the only case", V::passed, {}, observed({vector({1, 2, 3})}), list},
    {"not started", V::not_started, all_nine, not_started(9)},
    {"started at one case", V::uncaught_exception, all_nine, at(8, three(1, 1, 1), not_started(9))},
    {"not started, and no last reply", V::uncaught_exception, all_nine, not_started(8)},
    {"crashed, then not started", V::crashed, all_nine, at(0, crashed_with(SIGABRT), not_started(9))},
    {"one reply is missing", V::protocol_violation, {1}, observed({two_points}), twice_two_points},
    {"no reply", V::protocol_violation, all_nine, {}},
    {"one reply too many", V::protocol_violation, {}, observed({two_points, two_points}), points},
    {"a crash before a wrong value", V::crashed, {5, 7}, at(5, crashed_with(SIGSEGV), at(7, three(1, 2, 3)))},
    {"a wrong value before a crash", V::wrong_value, {3, 5}, at(5, crashed_with(SIGSEGV), at(3, three(1, 2, 3)))},
    {"rejected", V::rejected_file, all_nine, refused(Refusal::rejected_file)},
    {"rejected, with a reason", V::rejected_file, all_nine, refused(Refusal::rejected_file, "There is no file.")},
    {"not compiled", V::compile_error, all_nine, refused(Refusal::compile_error)},
    {"no function", V::missing_function, all_nine, refused(Refusal::missing_function)},
    {"our own error", V::checker_error, all_nine, refused(Refusal::checker_error)},
    {"an exercise without cases", V::checker_error, {}, {}, no_cases},
};

const std::vector<Judged> at_one_case = {
    {"not started at one case", V::uncaught_exception, {2}, at(2, ending(E::not_started))},
    {"an exception", V::uncaught_exception, {2}, at(2, ending(E::exception, "index 7 of\n3 entries"))},
    {"a silent exception", V::uncaught_exception, {2}, at(2, ending(E::exception))},
    {"a long exception", V::uncaught_exception, {2}, at(2, ending(E::exception, std::string(299, 'x') + "ωωω"))},
    {"a crash", V::crashed, {2}, at(2, crashed_with(SIGSEGV))},
    {"a whole number divided by zero", V::crashed, {2}, at(2, crashed_with(SIGFPE))},
    {"an odd signal", V::crashed, {2}, at(2, crashed_with(SIGUSR1))},
    {"no stack", V::crashed, {2}, at(2, crashed_with(SIGSEGV, CrashCause::stack_overflow))},
    {"an abort", V::crashed, {2}, at(2, crashed_with(SIGABRT))},
    {"an exception that cannot be caught",
     V::crashed,
     {2},
     at(2, crashed_with(SIGABRT, CrashCause::uncaught_exception))},
    {"exit", V::stopped_early, {2}, at(2, ending(E::stopped_early))},
    {"no end", V::time_limit, {2}, at(2, ending(E::time_limit))},
    {"too much memory", V::memory_limit, {2}, at(2, ending(E::memory_limit))},
    {"too much output", V::output_limit, {2}, at(2, ending(E::output_limit))},
    {"a file", V::forbidden_operation, {2}, at(2, forbidden(257))},
    {"something forbidden", V::forbidden_operation, {2}, at(2, ending(E::forbidden_operation))},
    {"a forged reply", V::protocol_violation, {2}, at(2, ending(E::protocol_violation, "more came than one reply"))},
    {"an odd reply", V::protocol_violation, {2}, at(2, ending(E::protocol_violation))},
    {"no time left", V::time_limit, {2}, at(2, ending(E::not_run))},
    {"another shape", V::wrong_shape, {2}, at(2, returning(vector({1, 2})))},
    {"fewer numbers than the shape says", V::protocol_violation, {2}, at(2, returning({3, 1, {1, 2}}))},
    {"NaN", V::non_finite_value, {2}, at(2, three(1, nan, 3))},
    {"infinity", V::non_finite_value, {2}, at(2, three(-infinity, 2, 3))},
    {"a wrong value", V::wrong_value, {2}, at(2, three(1, 2, 3))},
    {"a number for a list", V::wrong_shape, {0}, observed({vector({1})}), list},
    {"too few points", V::wrong_shape, {0}, at(0, of_shape(3, 1), not_started(1)), points},
    {"points in rows", V::wrong_shape, {0}, at(0, of_shape(2, 3), not_started(1)), points},
    {"no matrices", V::wrong_shape, {0}, observed({{3, 0, {}}}), matrices},
};

const std::vector<Judged> when_run_again = {
    {"again: the last bit", V::passed, {}, again(0, three(4 * (1 + 1e-15), 0, 22))},
    {"again: the other sign", V::passed, {}, again(0, returning(vector({-1})), observed({vector({1})})), quaternion},
    {"again: a crash", V::crashed, {4}, again(4, crashed_with(SIGSEGV))},
    {"again: not started", V::uncaught_exception, {4}, again(4, ending(E::not_started))},
    {"again: another shape", V::wrong_shape, {4}, again(4, returning(vector({1})))},
    {"again: NaN", V::inconsistent_value, {4}, again(4, three(1, nan, 3))},
    {"again: the second repeat", V::inconsistent_value, {0}, again(0, three(4, 5, 22), again(8, three(0, 0, 0)))},
    {"again: behind a rounding error", V::inconsistent_value, {0}, again(0, three(4 + 1e-15, 0.5, 22))},
    {"again: just beyond the tolerance", V::inconsistent_value, {0}, again(0, three(4, 0, 22 * (1 + 1.5e-9)))},
    {"again: not the first that fails", V::inconsistent_value, {3, 2}, again(3, three(4, 5, 7), two_wrong)},
    {"again: NaN at first", V::inconsistent_value, {2}, again(2, three(nan, 3, 1), at(2, three(nan, nan, 1)))},
    {"again: the same NaN", V::non_finite_value, {2}, again(2, three(1, nan, 3), at(2, three(1, infinity, 3)))},
    {"again: a case that does not exist", V::checker_error, {}, again(9, three(0, 0, 0))},
};

const std::string verdict_names =
    "passed wrong_value non_finite_value wrong_shape not_started waiting compile_error missing_function "
    "uncaught_exception crashed stopped_early time_limit memory_limit output_limit forbidden_operation "
    "protocol_violation "
    "inconsistent_value rejected_file checker_error ";

}  // namespace

TEST_CASE("Whatever is observed gets its verdict, the cases that fail, one sentence and a next step") {
  std::string text;
  std::set<V> verdicts;
  std::set<E> endings;
  for (const auto& table : {of_all_replies, at_one_case, when_run_again}) {
    for (const Judged& one : table) {
      CAPTURE(one.about);
      const Judgement judgement = judge(one.exercise, one.observation);
      CHECK(to_string(judgement.verdict) == to_string(one.verdict));
      CHECK(judgement.failing == one.failing);
      CHECK(judgement.passed() == (one.verdict == V::passed));
      CHECK(judgement.cases_passed() + one.failing.size() == one.exercise.cases.size());
      CHECK(judgement.message.find('\n') == std::string::npos);
      CHECK_FALSE(judgement.next_step.empty());
      verdicts.insert(judgement.verdict);
      for (const Reply& reply : one.observation.replies) endings.insert(reply.ending);
      text += fmt::format("{}: {}\n  {}\n  {}\n", one.about, in_words(to_string(judgement.verdict)), judgement.message,
                          judgement.next_step);
    }
  }
  CHECK(verdicts.size() == static_cast<std::size_t>(V::checker_error));  // all but waiting, which needs other exercises
  CHECK(endings.size() == static_cast<std::size_t>(E::not_run) + 1);
  compare_with_golden_file("verdicts.txt", text);
}

TEST_CASE("Verdicts and kinds of reasons have the names that programs read") {
  std::string verdicts;
  for (int k = 0; k <= static_cast<int>(V::checker_error); ++k) {
    const nlohmann::json name = static_cast<V>(k);
    CHECK(name.get<V>() == static_cast<V>(k));
    verdicts += name.get<std::string>() + " ";
  }
  CHECK(verdicts == verdict_names);
  CHECK(nlohmann::json("excellent").get<V>() == V::checker_error);
  std::string kinds;
  for (int k = 0; k <= static_cast<int>(ReasonKind::property); ++k)
    kinds += to_string(static_cast<ReasonKind>(k)) + " ";
  CHECK(kinds ==
        "code repair misconception term transform input_transform difference split independence entry place accuracy "
        "learnt property ");
}

TEST_CASE("A sample is spread from the first to the last, and repeats run backwards") {
  CHECK(evenly_spaced({4, 5, 6, 7, 8, 9, 10}, 3) == Cases{4, 7, 10});
  CHECK(evenly_spaced({4, 5}, 3) == Cases{4, 5});
  CHECK(evenly_spaced({}, 3).empty());
  CHECK(plan_repeats(momentum()) == Cases{8, 4, 0});
  CHECK(plan_repeats(quaternion) == Cases{0});
}

}  // namespace workbook::testing
