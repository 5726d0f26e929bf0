// The first failing case in full: what a student sees on a terminal of 80 columns.
#include "checker/judging/failure_text.hpp"
#include "checker/judging/judge.hpp"
#include "checker/judging/text_blocks.hpp"
#include "checker/judging/value_text.hpp"
#include "checker/messages/judging.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace workbook::testing {
namespace {

std::string shown(const ExerciseReference& exercise, const std::vector<Value>& values) {
  return "\n" + joined(describe_failure(exercise, judge(exercise, observed(values))));
}

Value diagonal(double a, double b, double c) { return three_rows({{a, 0, 0}, {0, b, 0}, {0, 0, c}}); }

std::size_t widest_line(const std::vector<std::string>& lines) {
  std::size_t width = 0;
  for (const std::string& line : lines) width = std::max(width, display_width(line));
  return width;
}

/// A value whose numbers all take many digits.
Value lengthy(int rows, int cols, double factor) {
  Value value{rows, cols, {}};
  for (int n = 0; n < rows * cols; ++n) value.numbers.push_back(-factor * std::exp(std::sin(7 * n + 1)));
  return value;
}

}  // namespace

TEST_CASE("Of an answer that passed there is nothing to show") {
  CHECK(describe_failure(momentum(), judge(momentum(), observed(outputs(momentum(), right_momentum)))).empty());
}

TEST_CASE("A wrong number stands beside the expected one") {
  ExerciseReference exercise = given_results(Kind::number, {number(4.82)});
  exercise.result_units = {units::joule};
  CHECK(shown(exercise, {number(9.64)}) == R"(
Case “number 0”

Inputs
  k = 0

Result y [kg m²/s²]
    expected   yours   difference
    4.82     ≠ 9.64    4.82

The error is 100 % of the size of the result: not rounding, but another
formula.
)");
}

TEST_CASE("A wrong vector is shown component by component, and only what differs is marked") {
  std::vector<Value> values = outputs(momentum(), right_momentum);
  values[0].numbers[2] = -22;
  CHECK(shown(momentum(), values) == R"(
Case “the worked one”

Inputs
  m = 2 kg
  u = (1, 2, 3) m/s
  v = (0.5, -1, 4) m/s

Result p [kg m/s]
      expected   yours   difference
  1    4           4       0
  2    0           0       0
  3   22       ≠ -22     -44

The error is 2 times the size of the result: not rounding, but another
formula.
)");
}

TEST_CASE("Matrices stand beside each other, with a mark at every entry that differs") {
  ExerciseReference exercise = given_results(Kind::matrix3, {three_rows({{43, -4, -4}, {-4, 36, -4}, {-4, -4, 17}})});
  exercise.arguments = {{"m", Kind::vector, units::kilogram}, {"r", Kind::points, units::metre}};
  exercise.cases[0].inputs = {vector({1, 2}), three_rows({{1, 0}, {0, 2.5}, {0, 0}})};
  exercise.result_name = "I";
  exercise.result_units = {units::moment_of_inertia};
  CHECK(shown(exercise, {three_rows({{43, 4, -4}, {4, 36, -4}, {-4, -4, 17.5}})}) == R"(
Case “number 0”

Inputs
  m = (1, 2) kg
  r [m], column by column
    1  1  0    0
    2  0  2.5  0

Result I [kg m²]
  expected         yours              difference
  43   -4   -4     43 ≠  4   -4       0 ≠ 8   0
  -4   36   -4   ≠  4   36   -4     ≠ 8   0   0
  -4   -4   17     -4   -4 ≠ 17.5     0   0 ≠ 0.5

The error is 19 % of the size of the result: not rounding, but another
formula.
)");
}

TEST_CASE("Points are shown number by number, column by column") {
  const ExerciseReference exercise = given_results(Kind::points, {three_rows({{1, 2}, {3, 4}, {5, 6.25}})});
  CHECK(shown(exercise, {three_rows({{1, 2}, {3, -4}, {5, 6.25}})}) == R"(
Case “number 0”

Inputs
  k = 0

Result y
                 expected   yours   difference
  column 1   1   1           1       0
             2   3           3       0
             3   5           5       0
  column 2   1   2           2       0
             2   4        ≠ -4      -8
             3   6.25        6.25    0

The error is 128 % of the size of the result: not rounding, but another
formula.
)");
}

TEST_CASE("A list of matrices is shown matrix by matrix, as input and as result") {
  const Value two = three_rows({{1, 0, 0, 4, 0, 0}, {0, 2, 0, 0, 5, 0}, {0, 0, 3, 0, 0, 6}});
  Value wrong = two;
  wrong.numbers[17] = 7;
  ExerciseReference exercise = given_results(Kind::matrices, {two});
  exercise.arguments = {{"tensors", Kind::matrices, units::moment_of_inertia}};
  exercise.cases[0].inputs = {two};
  CHECK(shown(exercise, {wrong}) == R"(
Case “number 0”

Inputs
  tensors [kg m²]
    matrix 1   matrix 2
    1  0  0    4  0  0
    0  2  0    0  5  0
    0  0  3    0  0  6

Result y
  matrix 1
  expected      yours         difference
  1   0   0     1   0   0     0   0   0
  0   2   0     0   2   0     0   0   0
  0   0   3     0   0   3     0   0   0
  matrix 2
  expected      yours         difference
  4   0   0     4   0   0     0   0   0
  0   5   0     0   5   0     0   0   0
  0   0   6     0   0 ≠ 7     0   0 ≠ 1

The error is 17 % of the size of the result: not rounding, but another
formula.
)");
}

TEST_CASE("Where the result's numbers have units of their own, each line ends with its unit") {
  ExerciseReference exercise = given_results(Kind::vector2, {vector({0.46, 2.5})});
  exercise.result_units = {units::joule, units::angular_momentum * units::angular_momentum};
  CHECK(contains(shown(exercise, {vector({0.46, 0.92})}), R"(
Result y
      expected   yours   difference
  1   0.46       0.46     0         kg m²/s²
  2   2.5      ≠ 0.92    -1.58      kg² m⁴/s²
)"));
}

TEST_CASE("As many digits are shown as tell the two numbers apart, up to 17") {
  const ExerciseReference exercise = given_results(Kind::number, {number(1.0 / 3)});
  CHECK(contains(shown(exercise, {number(1.0 / 3 + 1e-8)}), R"(
    expected       yours          difference
    0.3333333333 ≠ 0.3333333433   1e-08
)"));
  ExerciseReference strict = exercise;
  strict.cases[0].tolerance = 1e-18;
  CHECK(contains(shown(strict, {number(std::nextafter(1.0 / 3, 1))}), "0.33333333333333331 ≠ 0.33333333333333337"));
}

TEST_CASE("NaN and infinity are marked, and the error has no size") {
  const ExerciseReference exercise = given_results(Kind::vector3, {vector({1, 2, 3})});
  const std::string text = shown(exercise, {vector({1, not_a_number, -infinity})});
  CHECK(contains(text, "  2   2        ≠  NaN     NaN\n"));
  CHECK(contains(text, "  3   3        ≠ -inf    -inf\n"));
  CHECK(contains(text, "The error has no size: a number is missing or infinite.\n"));
  CHECK(contains(shown(exercise, {vector({1, not_a_number, 3})}), "The error has no size"));
}

TEST_CASE("Where no value came back the expected one is shown alone") {
  Observation observation;
  observation.replies = {ending(Ending::exception)};
  const ExerciseReference exercise = given_results(Kind::vector2, {vector({1, 2})});
  CHECK("\n" + joined(describe_failure(exercise, judge(exercise, observation))) == R"(
Case “number 0”

Inputs
  k = 0

Result y
      expected
  1   1
  2   2
  No value of yours can be shown.
)");
  const ExerciseReference empty = given_results(Kind::points, {three_rows({{}, {}, {}})});
  CHECK(contains(joined(describe_failure(empty, judge(empty, observation))), "  an empty list\n"));
}

TEST_CASE("A quaternion is shown against the sign that is nearer") {
  ExerciseReference exercise = given_results(Kind::vector, {vector({0.5, 0.5, 0.5, 0.5})});
  exercise.comparison = Comparison::up_to_sign;
  const std::string text = shown(exercise, {vector({-0.5, -0.5, -0.5, 0.5})});
  CHECK(contains(text, "  1   -0.5       -0.5    0\n"));
  CHECK(contains(text, "  4   -0.5     ≠  0.5    1\n"));
  CHECK(contains(text, "Expected is this value or its negative, whichever is nearer to yours."));
}

TEST_CASE("Of eigenvectors the equations that fail are shown, not differences of entries") {
  ExerciseReference exercise = given_results(Kind::matrix3, {diagonal(1, 1, 1)});
  exercise.arguments = {{"I", Kind::matrix3, units::moment_of_inertia}};
  exercise.cases[0].inputs = {diagonal(1, 2, 3)};
  exercise.comparison = Comparison::eigenvectors;
  CHECK(shown(exercise, {diagonal(1, 1, -2)}) == R"(
Case “number 0”

Inputs
  I [kg m²]
    1  0  0
    0  2  0
    0  0  3

Result y
  expected      yours
  1   0   0     1   0    0
  0   1   0     0   1    0
  0   0   1     0   0   -2

Vᵀ V − 1: zero for a right answer.
  0   0   0
  0   0   0
  0   0 ≠ 3

det V − 1: zero for a right answer.
≠ -3
)");
  CHECK(contains(shown(exercise, {three_rows({{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}})}), R"(
I V − V D: zero for a right answer.
   0 ≠ -1   0
≠ -1    0   0
   0    0   0
)"));
}

TEST_CASE("Of angles the difference of the rotation matrices is shown") {
  ExerciseReference exercise = given_results(Kind::vector3, {vector({0, 0, 0})});
  exercise.comparison = Comparison::attitude_by_angles;
  const std::string text = shown(exercise, {vector({0, 1, 0})});
  CHECK(contains(text, "      expected   yours\n  1   0          0\n  2   0          1\n"));
  CHECK(contains(text, "R(yours) − R(expected): zero for a right answer.\n"));
  CHECK(contains(text, "\n≠ -0.46    0 ≠ -0.841\n   0       0    0\n≠  0.841   0 ≠ -0.46\n"));
  CHECK_FALSE(contains(text, "The error is"));
}

TEST_CASE("A drift is shown only where every entry is right") {
  ExerciseReference exercise = given_results(Kind::points, {three_rows({{1, 0}, {0, 1}, {0, 0}})});
  exercise.properties = {{PropertyKind::constant_weighted_square, "The energy stays the same.", "", -1, {{1, 1, 1}}}};
  exercise.cases[0].tolerance = 1e-3;
  exercise.cases[0].scale = {100};
  const std::string drifting = shown(exercise, {three_rows({{1, 0}, {0, 1.05}, {0, 0}})});
  CHECK(contains(drifting, "\nThe energy stays the same.\ncolumn 2 is off by ≠ 0.103\n"));
  CHECK_FALSE(contains(drifting, "The error is"));
  CHECK_FALSE(contains(drifting.substr(0, drifting.find("The energy")), "≠"));
  CHECK_FALSE(contains(shown(exercise, {three_rows({{1, 0}, {0, 7}, {0, 0}})}), "The energy"));
}

TEST_CASE("Of a long list the numbers that differ are shown, and how many are left out") {
  Value expected{40, 1, std::vector<double>(40, 1.0)};
  Value wrong = expected;
  wrong.numbers[30] = 2;
  const ExerciseReference exercise = given_results(Kind::vector, {expected});
  CHECK(contains(shown(exercise, {wrong}), "  31   1        ≠ 2       1\n  (39 more numbers not shown)\n"));

  Value many{3, 40, std::vector<double>(120, 1.0)};
  Value other = many;
  other.numbers[100] = 2;
  const std::string columns = shown(given_results(Kind::points, {many}), {other});
  CHECK(contains(columns, "column 34   1   1          1       0\n              2   1        ≠ 2       1\n"));
  CHECK(contains(columns, "  (117 more numbers not shown)\n"));

  for (double& entry : wrong.numbers) entry = 3;
  CHECK(contains(shown(exercise, {wrong}), "  (16 more numbers not shown)\n"));
}

TEST_CASE("Long inputs are wrapped in columns, and very long ones cut") {
  ExerciseReference exercise = given_results(Kind::number, {number(1)});
  exercise.arguments = {{"times", Kind::vector, units::second}, {"r", Kind::points, units::metre}};
  exercise.cases[0].inputs = {lengthy(20, 1, 1), lengthy(3, 30, 1)};
  const auto lines = describe_failure(exercise, judge(exercise, observed({number(2)})));
  CHECK(contains(joined(lines), "\n  times [s]\n"));
  CHECK(contains(joined(lines), "\n    24  "));
  CHECK_FALSE(contains(joined(lines), "\n    25  "));
  CHECK(contains(joined(lines), "\n    (6 more columns not shown)\n"));
  CHECK(widest_line(lines) <= page_width);
}

TEST_CASE("Every kind fits on the page, with all its digits") {
  struct Sized {
    Kind kind;
    int rows;
    int cols;
  };
  for (const Sized& one : {Sized{Kind::number, 1, 1}, Sized{Kind::vector3, 3, 1}, Sized{Kind::matrix3, 3, 3},
                           Sized{Kind::points, 3, 5}, Sized{Kind::matrices, 3, 9}}) {
    for (double factor : {1.0, 1e-7, 1e9}) {
      const Value expected = lengthy(one.rows, one.cols, factor);
      Value wrong = expected;
      for (double& entry : wrong.numbers) entry = std::nextafter(entry, 0);
      ExerciseReference exercise = given_results(one.kind, {expected});
      exercise.arguments = {{"argument", one.kind, units::angular_momentum}};
      exercise.cases[0].inputs = {expected};
      exercise.cases[0].tolerance = 1e-20;
      const auto lines = describe_failure(exercise, judge(exercise, observed({wrong})));
      CAPTURE(joined(lines));
      // Only three full numbers with exponents, and their column's number, need the margin too.
      CHECK(widest_line(lines) <= (factor == 1e-7 ? page_width + 2 : page_width));
    }
  }
}

TEST_CASE("On a narrow page the results of every kind fit, one number below the other where columns do not") {
  for (const Kind kind : {Kind::number, Kind::vector3, Kind::matrix3, Kind::points}) {
    const int rows = kind == Kind::number ? 1 : 3;
    const int cols = kind == Kind::matrix3 ? 3 : kind == Kind::points ? 5 : 1;
    const Value expected = lengthy(rows, cols, 1);
    Value wrong = expected;
    for (double& entry : wrong.numbers) entry = std::nextafter(entry, 0);
    ExerciseReference exercise = given_results(kind, {expected});
    exercise.cases[0].tolerance = 1e-20;
    const auto lines = describe_failure(exercise, judge(exercise, observed({wrong})), {.width = 40});
    CAPTURE(joined(lines));
    CHECK(widest_line(lines) <= 40);
    CHECK(contains(joined(lines), "yours ≠ "));
  }
}

TEST_CASE("On a linear page every number that differs has lines of its own, and the rest are counted") {
  std::vector<Value> values = outputs(momentum(), right_momentum);
  values[0].numbers[2] = -22;
  const Judgement judgement = judge(momentum(), observed(values));
  const auto lines = describe_failure(momentum(), judgement, {.is_linear = true});
  CAPTURE(joined(lines));
  CHECK(contains("\n" + joined(lines), R"(
Result p [kg m/s]
  component 3
      expected    22
         yours ≠ -22
    difference   -44
  (the other 2 numbers agree)
)"));
}

TEST_CASE("The size of an error is said in words") {
  CHECK(messages::error_size(600, 1e-9) ==
        "The error is 600 times the size of the result: look for a wrong power or unit.");
  CHECK(messages::error_size(1.5, 1e-9) ==
        "The error is 1.5 times the size of the result: not rounding, but another formula.");
  CHECK(messages::error_size(0.05, 1e-9) ==
        "The error is 5 % of the size of the result: not rounding, but another formula.");
  CHECK(messages::error_size(1e-4, 1e-9) ==
        "The error is about 1 part in 10⁴ of the size of the result: too large for rounding, so look for an "
        "approximation.");
  CHECK(messages::error_size(3e-8, 1e-9) ==
        "The error is about 1 part in 10⁸ of the size of the result, 30 times what is allowed: digits are lost, as "
        "with float or "
        "3.14159.");
  CHECK(messages::error_size(infinity, 1e-9) == "The error has no size: a number is missing or infinite.");
}

}  // namespace workbook::testing
