// The verdict on everything that can be seen of a student's function, and the sentence that goes with it.
#include "checker/judging/judge.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>

#include <csignal>

namespace workbook::testing {
namespace {

struct Told {
  std::string about;
  Verdict verdict;
  std::string message;
  std::string next_step;
};

void check_told(const Judgement& judgement, const Told& told) {
  CAPTURE(told.about);
  CHECK(judgement.verdict == told.verdict);
  CHECK(judgement.message == told.message);
  CHECK(judgement.next_step == told.next_step);
}

Observation right() { return observed(outputs(momentum(), right_momentum)); }

/// Right everywhere but at the case "generic 2".
Observation right_but(Reply reply) {
  Observation observation = right();
  observation.replies[2] = std::move(reply);
  return observation;
}

Reply crashed_with(int signal, const std::string& text = "") {
  Reply reply = ending(Ending::crashed);
  reply.signal = signal;
  reply.text = text;
  return reply;
}

Reply stopped_with(int exit_status) {
  Reply reply = ending(Ending::stopped_early);
  reply.exit_status = exit_status;
  return reply;
}

const std::string only_the_function =
    "Let the file hold the function and its helpers only, and let it return its result.";
const std::string compare_entries =
    "Compare your value with the expected one entry by entry, and work this case out by hand.";
const std::string depends_on_arguments_only =
    "Let the result depend on the arguments alone: look for static variables, random numbers, the clock, or variables "
    "that "
    "are never set.";

struct Ended {
  Reply reply;
  Told told;
};

std::vector<Ended> endings() {
  return {
      {ending(Ending::not_started),
       {"not started at one case", Verdict::uncaught_exception,
        "The function still reports that it is not started at the case “generic 2”, but not everywhere.",
        "Remove what is left of the TODO, so that every way through the function returns a result."}},
      {ending(Ending::exception, "index 7 of\n3 entries"),
       {"an exception", Verdict::uncaught_exception,
        "The function threw an exception at the case “generic 2”: index 7 of 3 entries",
        "Check the indices and sizes that the message names, and print the inputs of this case if in doubt."}},
      {ending(Ending::exception),
       {"a silent exception", Verdict::uncaught_exception,
        "The function threw an exception at the case “generic 2”: it says nothing more.",
        "Check the indices and sizes that the message names, and print the inputs of this case if in doubt."}},
      {crashed_with(SIGSEGV),
       {"a crash", Verdict::crashed, "The function crashed at the case “generic 2”: signal 11 (segmentation fault).",
        "Look for an index beyond the end, a reference to something that is gone, or a recursion without an end."}},
      {crashed_with(SIGFPE),
       {"a division of whole numbers", Verdict::crashed,
        "The function crashed at the case “generic 2”: signal 8 (arithmetic exception, such as a whole number divided "
        "by zero).",
        "Look for a whole number that is divided by a variable which can be 0."}},
      {crashed_with(SIGSEGV, "the stack is used up"),
       {"a used-up stack", Verdict::crashed,
        "The function crashed at the case “generic 2”: the stack is used up, by calls that never end or by a very "
        "large "
        "local array.",
        "Give the recursion an end that every input reaches, or make the array a std::vector."}},
      {crashed_with(SIGABRT, "too late"),
       {"an exception that nobody could catch", Verdict::crashed,
        "The function crashed at the case “generic 2”: signal 6 (abort); nobody caught the exception “too late”.",
        "Look for an exception that leaves a destructor or a function marked noexcept."}},
      {stopped_with(0),
       {"exit", Verdict::stopped_early,
        "The program ended at the case “generic 2” before the function returned, with exit status 0.",
        "Remove calls such as exit or abort: a function hands its result back with return."}},
      {ending(Ending::time_limit),
       {"an endless loop", Verdict::time_limit, "The function did not return in time at the case “generic 2”.",
        "Look for a loop that never ends, or for a step that is far too small."}},
      {ending(Ending::memory_limit),
       {"too much memory", Verdict::memory_limit,
        "The function asked for more memory than an exercise may use at the case “generic 2”.",
        "Look for a size computed from the wrong number, or for a list that grows in every step."}},
      {ending(Ending::output_limit),
       {"too much output", Verdict::output_limit,
        "The function printed more than the checker reads at the case “generic 2”.",
        "Remove the printing, or keep it out of the loop."}},
      {ending(Ending::forbidden_operation, "it opened a file."),
       {"a file", Verdict::forbidden_operation,
        "The function tried something that no exercise needs at the case “generic 2”: it opened a file.",
        "Compute the result from the arguments alone: no files, no network, no other programs."}},
      {ending(Ending::forbidden_operation),
       {"something unknown", Verdict::forbidden_operation,
        "The function tried something that no exercise needs at the case “generic 2”.",
        "Compute the result from the arguments alone: no files, no network, no other programs."}},
      {ending(Ending::protocol_violation, "a reply before its request"),
       {"a forged reply", Verdict::protocol_violation,
        "Something other than the function answered at the case “generic 2”: a reply before its request.",
        only_the_function}},
      {ending(Ending::not_run),
       {"no time left", Verdict::time_limit,
        "The time for this exercise was used up before the function could be run at the case “generic 2”.",
        "Make the function faster: look for steps that are far too small, or for work that is done again and again."}},
      {returning({3, 1, {1, 2}}),
       {"a damaged value", Verdict::protocol_violation,
        "The reply at the case “generic 2” does not hold as many numbers as its shape says.", only_the_function}},
      {returning(vector({1, 2})),
       {"a value of another shape", Verdict::wrong_shape,
        "The result has the shape 2×1 at the case “generic 2”, expected the shape 3×1.",
        "Give the result its size from the sizes of the arguments before you fill it."}},
      {returning(vector({1, not_a_number, infinity})),
       {"NaN", Verdict::non_finite_value, "Component 2 is not a number (NaN) at the case “generic 2”.",
        "Look for a division by zero, the root of a negative number, an acos beyond 1, or an entry that is never "
        "set."}},
      {returning(vector({1, 2, -infinity})),
       {"infinity", Verdict::non_finite_value, "Component 3 is infinite at the case “generic 2”.",
        "Look for a division by zero, the root of a negative number, an acos beyond 1, or an entry that is never "
        "set."}},
      {returning(vector({1, 2, 3})),
       {"a wrong value", Verdict::wrong_value, "The value is wrong at 1 of 9 cases, first at the case “generic 2”.",
        compare_entries}},
  };
}

}  // namespace

TEST_CASE("An answer that is right at all cases passes, without any diagnosis") {
  const Judgement judgement = judge(sound_momentum(), right());
  check_told(judgement, {"right", Verdict::passed, "All 9 cases agree with the reference.",
                         "Go on to the next exercise, or read in the notes what to try next."});
  CHECK(judgement.passed());
  CHECK(judgement.cases_passed == 9);
  CHECK(judgement.cases_total == 9);
  CHECK(judgement.diagnoses.empty());
  CHECK_FALSE(judgement.first_failure.has_value());
}

TEST_CASE("Whatever happens at one case decides the verdict, and the other cases still count") {
  for (const Ended& ended : endings()) {
    const Judgement judgement = judge(momentum(), right_but(ended.reply));
    check_told(judgement, ended.told);
    CHECK(judgement.cases_passed == 8);
    REQUIRE(judgement.first_failure.has_value());
    CHECK(judgement.first_failure->case_index == 2);
    const bool can_be_shown =
        judgement.verdict == Verdict::wrong_value || judgement.verdict == Verdict::non_finite_value;
    CHECK(judgement.first_failure->actual.has_value() == can_be_shown);
  }
}

TEST_CASE("The first failing case decides, in the order of the cases") {
  Observation observation = right();
  observation.replies[5] = crashed_with(SIGSEGV);
  observation.replies[7] = returning(vector({1, 2, 3}));
  CHECK(judge(momentum(), observation).verdict == Verdict::crashed);
  observation.replies[3] = returning(vector({1, 2, 3}));
  const Judgement judgement = judge(momentum(), observation);
  CHECK(judgement.verdict == Verdict::wrong_value);
  CHECK(judgement.message == "The value is wrong at 3 of 9 cases, first at the case “generic 3”.");
  CHECK(judgement.cases_passed == 6);
}

TEST_CASE("A wrong shape is told in the words of its kind") {
  struct Shaped {
    Kind kind;
    Value expected;
    Value actual;
    std::string message;
  };
  const std::vector<Shaped> shaped = {
      {Kind::vector, vector({1, 2, 3}), vector({1}),
       "The result has 1 component at the case “number 0”, expected 3 components."},
      {Kind::points, three_rows({{1, 2}, {1, 2}, {1, 2}}), three_rows({{1}, {1}, {1}}),
       "The result has 1 column at the case “number 0”, expected 2 columns."},
      {Kind::matrices,
       three_rows({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
       {3, 0, {}},
       "The result has 0 matrices at the case “number 0”, expected 1 matrix."},
      {Kind::points,
       three_rows({{1, 2}, {1, 2}, {1, 2}}),
       {2, 3, std::vector<double>(6)},
       "The result has the shape 2×3 at the case “number 0”, expected 2 columns."},
  };
  for (const Shaped& one : shaped) {
    const ExerciseReference exercise = given_results(one.kind, {one.expected});
    const Judgement judgement = judge(exercise, observed({one.actual}));
    CHECK(judgement.verdict == Verdict::wrong_shape);
    CHECK(judgement.message == one.message);

    // The same where only rows and columns came back.
    Observation without_numbers;
    without_numbers.replies = {ending(Ending::wrong_shape)};
    without_numbers.replies[0].value = {one.actual.rows, one.actual.cols, {}};
    CHECK(judge(exercise, without_numbers).verdict == Verdict::wrong_shape);
    CHECK(judge(exercise, without_numbers).message == one.message);
  }
}

TEST_CASE("An exercise is not started only if no case was") {
  Observation observation;
  observation.replies.assign(9, ending(Ending::not_started));
  check_told(judge(momentum(), observation),
             {"untouched", Verdict::not_started, "You have not started this exercise: the TODO is still there.",
              "Open the file, replace the TODO by your formula, and check again."});
  CHECK_FALSE(judge(momentum(), observation).first_failure.has_value());

  observation.replies.pop_back();
  CHECK(judge(momentum(), observation).verdict == Verdict::uncaught_exception);
  observation.replies.push_back(returning(vector({0, 0, 0})));
  CHECK(judge(momentum(), observation).verdict == Verdict::uncaught_exception);
  observation.replies[0] = crashed_with(SIGABRT);
  CHECK(judge(momentum(), observation).message ==
        "The function crashed at the case “the worked one”: signal 6 (abort).");
}

TEST_CASE("A reply that is missing fails, and so does one too many") {
  Observation fewer = right();
  fewer.replies.pop_back();
  check_told(judge(momentum(), fewer),
             {"one too few", Verdict::protocol_violation, "No reply came back at the case “at rest”.",
              "Check that the function returns at every input and does not end the program."});
  CHECK(judge(momentum(), fewer).cases_passed == 8);

  Observation none;
  CHECK(judge(momentum(), none).verdict == Verdict::protocol_violation);
  CHECK(judge(momentum(), none).cases_passed == 0);

  Observation more = right();
  more.replies.push_back(returning(vector({0, 0, 0})));
  check_told(judge(momentum(), more),
             {"one too many", Verdict::protocol_violation, "There were 10 replies to 9 calls.", only_the_function});
}

TEST_CASE("A refusal comes before everything else, in its own words or in usual ones") {
  const std::string doctor =
      "This is not your fault and costs no points: run `checker doctor`, and tell your instructor if it stays.";
  struct Refused {
    Refusal refusal;
    Told told;
  };
  const std::vector<Refused> refusals = {
      {Refusal::rejected_file,
       {"file", Verdict::rejected_file, "The file cannot be taken as an exercise.",
        "Check that it is the right file, plain C++ text and not empty."}},
      {Refusal::compile_error,
       {"compiler", Verdict::compile_error, "The file does not compile.",
        "Mend the first error that the compiler shows; the later ones often follow from it."}},
      {Refusal::missing_function,
       {"function", Verdict::missing_function, "The file compiles, but the function of the exercise is not in it.",
        "Keep name and parameters as the header declares them, in namespace rigid: Vector3d momentum(double m, const "
        "Vector3d& "
        "u, const Vector3d& v)."}},
      {Refusal::checker_error, {"checker", Verdict::checker_error, "Something went wrong in the checker.", doctor}},
  };
  for (const Refused& refused : refusals) {
    Observation observation = right();
    observation.refusal = refused.refusal;
    check_told(judge(momentum(), observation), refused.told);
    CHECK(judge(momentum(), observation).cases_passed == 0);
    observation.refusal_message = "There is no file.";
    CHECK(judge(momentum(), observation).message == "There is no file.");
    CHECK(judge(momentum(), observation).next_step == refused.told.next_step);
  }
}

TEST_CASE("An exercise without cases is an error of ours, not a pass") {
  ExerciseReference empty = momentum();
  empty.cases.clear();
  const Judgement judgement = judge(empty, Observation{});
  CHECK(judgement.verdict == Verdict::checker_error);
  CHECK(judgement.message == "The reference results hold no cases for momentum.");
}

TEST_CASE("Results that change when a case is run again are inconsistent, whether right at first or wrong") {
  Observation observation = right();
  observation.repeats = {{8, returning(vector({0, 0, 0}))}, {0, returning(vector({4, 0.5, 22}))}};
  check_told(judge(momentum(), observation), {"right at first", Verdict::inconsistent_value,
                                              "The same input gave two results at the case “the worked one”: component "
                                              "2 was 0 at first and 0.5 when run again.",
                                              depends_on_arguments_only});
  CHECK(judge(momentum(), observation).cases_passed == 9);

  Observation random = observed(outputs(sound_momentum(), momentum_with(1, 1)));
  random.repeats = {{0, returning(outputs(momentum(), momentum_with(1, 1.1))[0])}};
  const Judgement judgement = judge(sound_momentum(), random);
  CHECK(judgement.verdict == Verdict::inconsistent_value);
  CHECK(judgement.diagnoses.empty());

  Observation unset = right_but(returning(vector({not_a_number, not_a_number, 1})));
  unset.repeats = {{2, returning(vector({not_a_number, 3, 1}))}};
  CHECK(judge(momentum(), unset).message ==
        "The same input gave two results at the case “generic 2”: component 2 was NaN at first and 3 when run again.");
}

TEST_CASE("Repeats that agree up to rounding change nothing") {
  Observation observation = right();
  Value again = observation.replies[3].value;
  again.numbers[0] *= 1 + 1e-15;
  observation.repeats = {{3, returning(again)}};
  CHECK(judge(momentum(), observation).passed());

  Observation wrong = right_but(returning(vector({1, not_a_number, 3})));
  wrong.repeats = {{2, returning(vector({1, not_a_number, 3}))}};
  CHECK(judge(momentum(), wrong).verdict == Verdict::non_finite_value);
}

TEST_CASE("A quaternion may come back with the other sign when run again") {
  ExerciseReference exercise = given_results(Kind::vector, {vector({0.6, 0.8})});
  exercise.comparison = Comparison::up_to_sign;
  Observation observation = observed({vector({0.6, 0.8})});
  observation.repeats = {{0, returning(vector({-0.6, -0.8}))}};
  CHECK(judge(exercise, observation).passed());
}

TEST_CASE("A repeat without a usable value fails, although every case had passed") {
  struct Again {
    Reply reply;
    Verdict verdict;
    std::string message;
  };
  const std::vector<Again> repeats = {
      {crashed_with(SIGSEGV), Verdict::crashed,
       "The function crashed when the case “generic 4” was run once more: signal 11 (segmentation fault)."},
      {ending(Ending::time_limit), Verdict::time_limit,
       "The function did not return in time when the case “generic 4” was run once more."},
      {ending(Ending::not_started), Verdict::uncaught_exception,
       "The function still reports that it is not started when the case “generic 4” was run once more, but not "
       "everywhere."},
      {ending(Ending::not_run), Verdict::time_limit,
       "The time for this exercise was used up before the function could be run when the case “generic 4” was run once "
       "more."},
      {ending(Ending::wrong_shape), Verdict::wrong_shape,
       "The result has the wrong shape when the case “generic 4” was run once more."},
      {returning(vector({1})), Verdict::wrong_shape,
       "The result has the shape 1×1 at the case “generic 4”, expected the shape 3×1."},
      {returning({3, 1, {}}), Verdict::protocol_violation,
       "The reply at the case “generic 4” does not hold as many numbers as its shape says."},
  };
  for (const Again& again : repeats) {
    CAPTURE(again.message);
    Observation observation = right();
    observation.repeats = {{4, again.reply}};
    const Judgement judgement = judge(momentum(), observation);
    CHECK(judgement.verdict == again.verdict);
    CHECK(judgement.message == again.message);
    CHECK_FALSE(judgement.next_step.empty());
  }
}

TEST_CASE("A repeat of a case that does not exist is an error of ours") {
  Observation observation = right();
  observation.repeats = {{9, returning(vector({0, 0, 0}))}};
  CHECK(judge(momentum(), observation).verdict == Verdict::checker_error);
  CHECK(judge(momentum(), observation).message == "A case was repeated that does not exist.");
}

TEST_CASE("A long exception text is cut, and not inside a character") {
  std::string text(299, 'x');
  text += "ωωω";
  const Judgement judgement = judge(momentum(), right_but(ending(Ending::exception, text)));
  CHECK(judgement.message ==
        "The function threw an exception at the case “generic 2”: " + std::string(299, 'x') + " …");
}

TEST_CASE("Verdicts and diagnoses have the names that programs read") {
  CHECK(to_string(Verdict::passed) == "passed");
  CHECK(to_string(Verdict::wrong_value) == "wrong_value");
  CHECK(to_string(Verdict::non_finite_value) == "non_finite_value");
  CHECK(to_string(Verdict::wrong_shape) == "wrong_shape");
  CHECK(to_string(Verdict::not_started) == "not_started");
  CHECK(to_string(Verdict::compile_error) == "compile_error");
  CHECK(to_string(Verdict::missing_function) == "missing_function");
  CHECK(to_string(Verdict::uncaught_exception) == "uncaught_exception");
  CHECK(to_string(Verdict::crashed) == "crashed");
  CHECK(to_string(Verdict::stopped_early) == "stopped_early");
  CHECK(to_string(Verdict::time_limit) == "time_limit");
  CHECK(to_string(Verdict::memory_limit) == "memory_limit");
  CHECK(to_string(Verdict::output_limit) == "output_limit");
  CHECK(to_string(Verdict::forbidden_operation) == "forbidden_operation");
  CHECK(to_string(Verdict::protocol_violation) == "protocol_violation");
  CHECK(to_string(Verdict::inconsistent_value) == "inconsistent_value");
  CHECK(to_string(Verdict::rejected_file) == "rejected_file");
  CHECK(to_string(Verdict::checker_error) == "checker_error");
  CHECK(to_string(DiagnosisKind::misconception) == "misconception");
  CHECK(to_string(DiagnosisKind::term) == "term");
  CHECK(to_string(DiagnosisKind::property) == "property");
  CHECK(to_string(DiagnosisKind::dimension) == "dimension");
  CHECK(to_string(DiagnosisKind::transform) == "transform");
}

}  // namespace workbook::testing
