// Why an answer is wrong: every diagnosis where it is true, and none where it is not.
#include "checker/judging/diagnosis.hpp"
#include "checker/judging/judge.hpp"
#include "checker/judging/misconceptions.hpp"
#include "checker/judging/terms.hpp"
#include "checker/judging/transforms.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace workbook::testing {
namespace {

/// The only diagnosis of an answer; "none" or "several" where there is not just one.
std::string only_message(const ExerciseReference& exercise, const std::vector<Value>& values) {
  const auto diagnoses = judge(exercise, observed(values)).diagnoses;
  if (diagnoses.size() != 1) return diagnoses.empty() ? "none" : "several";
  return diagnoses.front().message;
}

std::string only_message(const ExerciseReference& exercise, const Function& wrong) {
  return only_message(exercise, outputs(exercise, wrong));
}

ExerciseReference momentum_with_terms() {
  ExerciseReference exercise = momentum();
  add_term(exercise, "m u", 1, momentum_with(1, 0));
  add_term(exercise, "m v", 2, momentum_with(0, 1));
  return exercise;
}

/// Generic vectors of a length; their unit is the radian.
ExerciseReference generic_vectors(Kind kind, int size) {
  std::vector<Value> expected;
  for (int k = 1; k <= 4; ++k) {
    std::vector<double> entries(size);
    for (int n = 0; n < size; ++n) entries[n] = std::sin(3 * k + 7 * n + 1);
    expected.push_back(vector(entries));
  }
  return given_results(kind, expected);
}

std::vector<Value> changed(const ExerciseReference& exercise, const std::function<Value(Value)>& change) {
  std::vector<Value> values;
  for (const Case& one : exercise.cases) values.push_back(change(one.expected));
  return values;
}

std::vector<Value> times(const ExerciseReference& exercise, double factor) {
  return changed(exercise, [factor](Value value) {
    for (double& entry : value.numbers) entry *= factor;
    return value;
  });
}

std::vector<Value> in_order(const ExerciseReference& exercise, const std::vector<std::size_t>& order) {
  return changed(exercise, [&order](const Value& value) {
    Value permuted = value;
    for (std::size_t n = 0; n < value.numbers.size(); ++n) permuted.numbers[n] = value.numbers[order[n]];
    return permuted;
  });
}

}  // namespace

// --- misconceptions

TEST_CASE("A misconception is named, alone, with the paragraph to read") {
  const ExerciseReference exercise = sound_momentum();
  for (const Misconception& wrong : exercise.misconceptions) {
    const Judgement judgement = judge(exercise, observed(wrong.outputs));
    CHECK(judgement.verdict == Verdict::wrong_value);
    CHECK(judgement.next_step == "Mend what the diagnosis names, and check again.");
    REQUIRE(judgement.diagnoses.size() == 1);
    CHECK(judgement.diagnoses[0].kind == DiagnosisKind::misconception);
    CHECK(judgement.diagnoses[0].name == wrong.name);
    CHECK(judgement.diagnoses[0].message == wrong.message);
    CHECK(judgement.diagnoses[0].notes == "made_up_anchor");
  }
}

TEST_CASE("A misconception is not named if one deciding case disagrees or has no value") {
  const ExerciseReference exercise = sound_momentum();
  const std::vector<Value>& wrong = exercise.misconceptions[0].outputs;
  Answers answers = all_answers(wrong);
  CHECK(diagnose_misconception(exercise, answers).has_value());
  answers[5]->numbers[1] += 1e-3;
  CHECK_FALSE(diagnose_misconception(exercise, answers).has_value());
  answers[5].reset();
  CHECK_FALSE(diagnose_misconception(exercise, answers).has_value());
}

TEST_CASE("What happens at a case that does not decide does not matter for a misconception") {
  const ExerciseReference exercise = sound_momentum();
  Answers answers = all_answers(exercise.misconceptions[0].outputs);
  answers.back().reset();
  CHECK(diagnose_misconception(exercise, answers).has_value());
}

TEST_CASE("Of two misconceptions with one message the first stands for both; with two messages neither is named") {
  ExerciseReference exercise = momentum();
  add_misconception(exercise, "no_two", "The velocity v enters twice.", momentum_with(1, 1));
  add_misconception(exercise, "mean", "The velocity v enters twice.", momentum_with(1, 1));
  const Answers answers = all_answers(outputs(exercise, momentum_with(1, 1)));
  REQUIRE(diagnose_misconception(exercise, answers).has_value());
  CHECK(diagnose_misconception(exercise, answers)->name == "no_two");
  add_misconception(exercise, "other", "You take the mean.", momentum_with(1, 1));
  CHECK_FALSE(diagnose_misconception(exercise, answers).has_value());
}

TEST_CASE("A misconception that is right at the deciding cases accuses nobody, right or wrong") {
  ExerciseReference exercise = momentum();
  add_misconception(exercise, "right", "You are right, and yet.", right_momentum);
  std::vector<Value> values = outputs(exercise, right_momentum);
  CHECK_FALSE(diagnose_misconception(exercise, all_answers(values)).has_value());
  values.back().numbers[0] = 1;  // wrong only at a case that does not decide
  CHECK(judge(exercise, observed(values)).verdict == Verdict::wrong_value);
  CHECK(only_message(exercise, values) == "none");
}

TEST_CASE("A misconception that is not finite is recognised by where it is not finite") {
  ExerciseReference exercise = momentum();
  const Function divides_by_zero = [](const Inputs& inputs) {
    Value value = right_momentum(inputs);
    value.numbers[1] = not_a_number;
    return value;
  };
  add_misconception(exercise, "divides_by_zero", "You divide by the second component of zero.", divides_by_zero);
  const std::vector<Value> values = outputs(exercise, divides_by_zero);
  CHECK(judge(exercise, observed(values)).verdict == Verdict::non_finite_value);
  CHECK(only_message(exercise, values) == "You divide by the second component of zero.");
}

TEST_CASE("Eigenvectors with other signs still show their misconception") {
  const Eigen::Matrix3d V = (Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized())).toRotationMatrix();
  const Eigen::Matrix3d I = V * Eigen::Vector3d(1, 2, 4).asDiagonal() * V.transpose();
  const auto as_value = [](const Eigen::Matrix3d& matrix) { return Value{3, 3, {matrix.data(), matrix.data() + 9}}; };
  ExerciseReference exercise = given_results(Kind::matrix3, {as_value(V)});
  exercise.arguments = {{"I", Kind::matrix3, units::moment_of_inertia}};
  exercise.cases[0].inputs = {as_value(I)};
  exercise.comparison = Comparison::eigenvectors;
  exercise.misconceptions = {{"rows", "The axes are your rows.", "", {as_value(V.transpose())}, {}}};
  const Eigen::Matrix3d signs = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  CHECK(only_message(exercise, {as_value(signs * V.transpose())}) == "The axes are your rows.");
}

// --- terms

TEST_CASE("A wrong coefficient is named with both numbers") {
  const ExerciseReference exercise = momentum_with_terms();
  struct Wrong {
    double of_u;
    double of_v;
    std::string message;
  };
  const std::vector<Wrong> answers = {
      {1, 1, "The term m v enters with 1, expected 2."},
      {1, -2, "The term m v enters with −2, expected 2."},
      {0.5, 2, "The term m u enters with 1/2, expected 1."},
      {1, 0, "The term m v is missing."},
      {0, 2, "The term m u is missing."},
      {2, 1, "The term m u enters with 2, expected 1, and the term m v enters with 1, expected 2."},
      {1, 2 + 1e-5, "The term m v enters with 2.00001, expected 2."},
  };
  for (const Wrong& answer : answers) {
    CAPTURE(answer.message);
    CHECK(only_message(exercise, momentum_with(answer.of_u, answer.of_v)) == answer.message);
  }
}

TEST_CASE("A diagnosis of a term says which") {
  const auto diagnosis = diagnose_terms(momentum_with_terms(), all_answers(outputs(momentum(), momentum_with(1, 1))));
  REQUIRE(diagnosis.has_value());
  CHECK(diagnosis->kind == DiagnosisKind::term);
  CHECK(diagnosis->name == "m v");
}

TEST_CASE("Nothing is said of terms if the answer is no sum of them, or right") {
  const ExerciseReference exercise = momentum_with_terms();
  const auto diagnosis = [&](const Function& function) {
    return diagnose_terms(exercise, all_answers(outputs(exercise, function)));
  };
  CHECK_FALSE(diagnosis(right_momentum).has_value());
  CHECK_FALSE(diagnosis([](const Inputs& inputs) { return inputs[1]; }).has_value());
  CHECK_FALSE(diagnosis([](const Inputs& inputs) {
                Value value = momentum_with(1, 1)(inputs);
                value.numbers[0] += 1e-4;
                return value;
              }).has_value());
  CHECK_FALSE(diagnosis([](const Inputs&) { return vector({not_a_number, 1, 1}); }).has_value());
}

TEST_CASE("Terms that depend on each other accuse nobody") {
  ExerciseReference exercise = momentum_with_terms();
  const Answers answers = all_answers(outputs(exercise, momentum_with(1, 1)));
  CHECK(diagnose_terms(exercise, answers).has_value());
  add_term(exercise, "m (u + v)", 0, momentum_with(1, 1));
  CHECK_FALSE(diagnose_terms(exercise, answers).has_value());
}

TEST_CASE("A term too small to show accuses nobody of rounding errors in it") {
  ExerciseReference exercise = momentum_with_terms();
  const Function small = [](const Inputs& inputs) {
    return vector({3e-8 * std::sin(40 * inputs[1].numbers[1]), 0, 0});
  };
  add_term(exercise, "small", 0, small);
  const auto with_small = [&](double of_v, double of_small) {
    std::vector<Value> values = outputs(exercise, momentum_with(1, of_v));
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i].numbers[0] += of_small * exercise.terms[2].outputs[i].numbers[0];
    }
    return only_message(exercise, values);
  };
  CHECK(with_small(1, 1e-3) == "The term m v enters with 1, expected 2.");
  CHECK(with_small(1, 10) == "The term m v enters with 1, expected 2, and the term small enters with 10, expected 0.");
}

TEST_CASE("Too few numbers to fit the terms accuse nobody") {
  ExerciseReference exercise = momentum_with_terms();
  const Answers answers = all_answers(outputs(exercise, momentum_with(1, 1)));
  for (Case& one : exercise.cases) one.deciding = false;
  exercise.cases[0].deciding = true;
  CHECK_FALSE(diagnose_terms(exercise, answers).has_value());
  exercise.cases[1].deciding = true;
  CHECK(diagnose_terms(exercise, answers).has_value());
}

TEST_CASE("More than two wrong coefficients are counted, not listed") {
  ExerciseReference exercise = momentum_with_terms();
  add_term(exercise, "v", 0, [](const Inputs& inputs) { return inputs[2]; });
  const Function wrong = [](const Inputs& inputs) {
    Value value = momentum_with(3, 1)(inputs);
    for (std::size_t n = 0; n < 3; ++n) value.numbers[n] += inputs[2].numbers[n];
    return value;
  };
  CHECK(only_message(exercise, wrong) ==
        "The term m u enters with 3, expected 1, and the term m v enters with 1, expected 2; 1 more is off.");
}

// --- transforms of the whole answer

TEST_CASE("A common factor is named, also where the formula has terms") {
  for (const ExerciseReference& exercise : {momentum(), momentum_with_terms()}) {
    CHECK(only_message(exercise, momentum_with(-1, -2)) ==
          "Your result is the negative of the expected one at every case: a sign is lost or one too many.");
    CHECK(only_message(exercise, momentum_with(2, 4)) == "Your result is 2 times the expected one at every case.");
    CHECK(only_message(exercise, momentum_with(0.5, 1)) == "Your result is half of the expected one at every case.");
    CHECK(only_message(exercise, momentum_with(-1.5, -3)) ==
          "Your result is −3/2 times the expected one at every case.");
    CHECK(only_message(exercise, momentum_with(0, 0)) ==
          "Your result is zero everywhere, also where the expected one is not.");
  }
  CHECK(only_message(momentum(), momentum_with(1, 1)) == "none");
}

TEST_CASE("A factor that one deciding case does not have is not named") {
  std::vector<Value> values = outputs(momentum(), momentum_with(2, 4));
  values[4] = outputs(momentum(), right_momentum)[4];
  CHECK(only_message(momentum(), values) == "none");
}

TEST_CASE("A single number is not enough for a common factor") {
  const ExerciseReference exercise = given_results(Kind::number, {number(3)});
  CHECK(only_message(exercise, {number(6)}) == "none");
}

TEST_CASE("Degrees are recognised only where an angle is asked for") {
  ExerciseReference exercise = generic_vectors(Kind::vector3, 3);
  const double degrees = 180 / std::numbers::pi;
  CHECK(only_message(exercise, times(exercise, degrees)) ==
        "Your result is 57.3 times the expected one at every case.");
  exercise.result_units = {units::radian_per_second};
  CHECK(only_message(exercise, times(exercise, degrees)) == "Your result is in degrees; angles here are in radians.");
  CHECK(only_message(exercise, times(exercise, 1 / degrees)) ==
        "Your result is converted from degrees to radians once too often: it is π/180 times the expected one.");
}

TEST_CASE("Components in another order are named in the order of the student") {
  const ExerciseReference exercise = generic_vectors(Kind::vector3, 3);
  CHECK(only_message(exercise, in_order(exercise, {1, 2, 0})) ==
        "Your components are the expected ones in another order: 2, 3, 1.");
  CHECK(only_message(exercise, in_order(exercise, {0, 2, 1})) ==
        "Your components are the expected ones in another order: 1, 3, 2.");
  const ExerciseReference pair = generic_vectors(Kind::vector2, 2);
  CHECK(only_message(pair, in_order(pair, {1, 0})) == "Your components are the expected ones in another order: 2, 1.");
  CHECK(only_message(pair, in_order(pair, {0, 0})) == "none");
}

TEST_CASE("A long vector is recognised in reverse order, a short one in any") {
  const ExerciseReference long_one = generic_vectors(Kind::vector, 6);
  CHECK(only_message(long_one, in_order(long_one, {5, 4, 3, 2, 1, 0})) ==
        "Your components are the expected ones in reverse order.");
  CHECK(only_message(long_one, in_order(long_one, {1, 0, 2, 3, 4, 5})) == "none");
  const ExerciseReference quaternion = generic_vectors(Kind::vector, 4);
  CHECK(only_message(quaternion, in_order(quaternion, {1, 2, 3, 0})) ==
        "Your components are the expected ones in another order: 2, 3, 4, 1.");
}

TEST_CASE("The rows of a list of points may be in another order") {
  const ExerciseReference exercise = given_results(Kind::points, {three_rows({{1, 2}, {3, 4}, {5, 6}})});
  CHECK(only_message(exercise, {three_rows({{5, 6}, {3, 4}, {1, 2}})}) ==
        "Your components are the expected ones in another order: 3, 2, 1.");
}

TEST_CASE("A transposed matrix is named unless it is symmetric") {
  const Value matrix = three_rows({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  const Value transposed = three_rows({{1, 4, 7}, {2, 5, 8}, {3, 6, 9}});
  const ExerciseReference exercise = given_results(Kind::matrix3, {matrix});
  CHECK(only_message(exercise, {transposed}) ==
        "Your matrix is the transpose of the expected one: rows and columns are exchanged.");
  const Judgement judgement = judge(exercise, observed({transposed}));
  CHECK(judgement.diagnoses.at(0).kind == DiagnosisKind::transform);
  CHECK(judgement.diagnoses.at(0).name == "transposed");
}

TEST_CASE("A right answer is no transform of itself") {
  const ExerciseReference exercise = momentum();
  CHECK_FALSE(diagnose_transform(exercise, all_answers(outputs(exercise, right_momentum))).has_value());
  const ExerciseReference symmetric = given_results(Kind::matrix3, {three_rows({{1, 2, 3}, {2, 5, 6}, {3, 6, 9}})});
  CHECK_FALSE(diagnose_transform(symmetric, all_answers({symmetric.cases[0].expected})).has_value());
}

// --- which comes first

TEST_CASE("A misconception comes before the term that says the same") {
  const ExerciseReference exercise = sound_momentum();
  CHECK(only_message(exercise, momentum_with(1, 1)) == "The velocity v enters twice, not once.");
  CHECK(only_message(exercise, momentum_with(1, 3)) == "The term m v enters with 3, expected 2.");
}

TEST_CASE("What explains an answer wholly leaves out the properties that it breaks") {
  ExerciseReference exercise = momentum();
  add_property(exercise, PropertyKind::nonnegative, "No component is negative");
  for (Case& one : exercise.cases) {
    for (double& entry : one.expected.numbers) entry = std::abs(entry);
  }
  CHECK(contains(only_message(exercise, times(exercise, -1)), "negative of the expected one"));
  std::vector<Value> values = times(exercise, -1);
  values[3].numbers[0] -= 1;
  CHECK(contains(only_message(exercise, values), "No component is negative"));
}

}  // namespace workbook::testing
