// A failing case in full, as a student reads it; the text is in golden/cases.txt.
#include "checker/report/reports.hpp"
#include "tests/judging/made_up.hpp"
#include "tests/support/files.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace workbook::testing {
namespace {

struct Shown {
  std::string about;
  Exercise exercise;
  std::optional<Value> actual;
};

/// An exercise with one case, its argument of the kind of its result.
Exercise mirrored(Kind kind, const Value& expected, Unit unit = units::none) {
  Exercise exercise = given_results(kind, {expected});
  exercise.arguments = {{"x", kind, unit}};
  exercise.cases[0].inputs = {expected};
  exercise.result_units = {unit};
  return exercise;
}

Value with_number(Value value, std::size_t number, double other) {
  value.numbers.at(number) = other;
  return value;
}

Value filled(int rows, int cols, double number) {
  return {rows, cols, std::vector<double>(static_cast<std::size_t>(rows * cols), number)};
}

/// A value whose numbers all take many digits.
Value lengthy(int rows, int cols, double factor) {
  Value value{rows, cols, {}};
  for (int n = 0; n < rows * cols; ++n) value.numbers.push_back(-factor * std::exp(std::sin(7 * n + 1)));
  return value;
}

std::vector<Shown> every_kind() {
  const Value tensor = three_rows({{43, -4, -4}, {-4, 36, -4}, {-4, -4, 17}});
  const Value points = three_rows({{1, 2}, {3, 4}, {5, 6.25}});
  const Value two = three_rows({{1, 0, 0, 4, 0, 0}, {0, 2, 0, 0, 5, 0}, {0, 0, 3, 0, 0, 6}});
  return {
      {"a number", mirrored(Kind::number, number(4.82), units::joule), number(9.64)},
      {"an integer", mirrored(Kind::integer, number(1)), number(-1)},
      {"two components", mirrored(Kind::vector2, vector({0.46, 2.5}), units::metre), vector({0.46, 0.92})},
      {"three components", momentum(), vector({4, 0, -22})},
      {"a list of numbers", mirrored(Kind::vector, vector({1, 20, 300, 0.5}), units::second), vector({1, 2, 300, 5})},
      {"a matrix", mirrored(Kind::matrix3, tensor, units::moment_of_inertia), with_number(tensor, 8, 17.5)},
      {"points", mirrored(Kind::points, points, units::metre), with_number(points, 4, -4)},
      {"matrices", mirrored(Kind::matrices, two, units::moment_of_inertia), with_number(two, 17, 7)},
  };
}

std::vector<Shown> every_comparison() {
  const auto quaternion = given_results(Kind::vector, {vector({0.5, 0.5, 0.5, 0.5})}, Comparison::up_to_sign);
  const auto angles = given_results(Kind::vector3, {vector({0, 0, 0})}, Comparison::attitude_by_angles);
  const Exercise axes = eigenvectors(diagonal(1, 2, 3), diagonal(1, 1, 1));
  return {
      {"a quaternion, nearer to the negative", quaternion, vector({-0.5, -0.5, -0.5, 0.5})},
      {"eigenvectors that are too long and left-handed", axes, diagonal(1, 1, -2)},
      {"eigenvectors in another order", axes, three_rows({{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}})},
      {"angles of another attitude", angles, vector({0, 1, 0})},
      {"a drift alone", conserved(), three_rows({{1, 0}, {0, 1.0009}, {2, 2}})},
      {"entries that are wrong, and drift too", conserved(), three_rows({{1, 0}, {0, 7}, {2, 2}})},
  };
}

std::vector<Shown> special() {
  Exercise own_units = mirrored(Kind::vector2, vector({0.46, 2.5}));
  own_units.result_units = {units::joule, units::angular_momentum * units::angular_momentum};
  const Exercise third = given_results(Kind::number, {number(1.0 / 3)});
  Exercise strict = third;
  strict.cases[0].tolerance = 1e-18;
  Exercise long_inputs = given_results(Kind::number, {number(1)});
  long_inputs.arguments = {{"times", Kind::vector, units::second}, {"r", Kind::points, units::metre}};
  long_inputs.cases[0].inputs = {lengthy(20, 1, 1), lengthy(3, 30, 1)};
  const Value forty = filled(40, 1, 1);
  const Value many = filled(3, 40, 1);
  return {
      {"numbers with units of their own", own_units, vector({0.46, 0.92})},
      {"a difference at the eighth digit", third, number(1.0 / 3 + 1e-8)},
      {"a difference at the last digit", strict, number(std::nextafter(1.0 / 3, 1))},
      {"NaN and infinity", given_results(Kind::vector3, {vector({1, 2, 3})}), vector({1, not_a_number, -infinity})},
      {"no value", given_results(Kind::vector2, {vector({1, 2})}), std::nullopt},
      {"an empty list, and no value", given_results(Kind::points, {filled(3, 0, 1)}), std::nullopt},
      {"one number of forty", given_results(Kind::vector, {forty}), with_number(forty, 30, 2)},
      {"all numbers of forty", given_results(Kind::vector, {forty}), filled(40, 1, 3)},
      {"one number of forty points", given_results(Kind::points, {many}), with_number(many, 100, 2)},
      {"long inputs", long_inputs, number(2)},
      {"something where zero is expected", given_results(Kind::vector2, {vector({0, 1})}), vector({0.25, 1})},
      {"a value that passes", momentum(), momentum().cases[0].expected},
  };
}

std::string described(const Shown& one, const std::string& where, const Page& page) {
  const auto lines = describe_case(one.exercise, 0, one.actual, page);
  CHECK_MESSAGE(widest(lines) <= page.width, one.about);
  for (const std::string& line : lines) CHECK_FALSE(line.ends_with(' '));
  return "--- " + one.about + where + "\n" + joined(lines);
}

std::string described(const Shown& one) {
  return described(one, "", {}) + error_size(one.exercise, {0}, {one.actual}) + "\n";
}

auto marks(const std::vector<std::string>& lines) {
  return std::ranges::count_if(lines, [](const std::string& line) { return has(line, "≠"); });
}

}  // namespace

TEST_CASE("A case is shown with its inputs, the expected value, the student's and their difference") {
  std::string text;
  for (const Shown& one : every_kind())
    text += described(one) + described(one, ", on 40 columns", {.width = 40}) +
            described(one, ", linear", {.is_linear = true});
  for (const auto& table : {every_comparison(), special()})
    for (const Shown& one : table) text += described(one);
  for (double error : {600.0, 1.5, 0.05, 1e-4, 3e-8, -0.5, -1.0, -1 + 1e-10, -2.0})
    text += fmt::format("{}: {}\n", error,
                        error_size(given_results(Kind::number, {number(2)}), {0}, {number(2 + 2 * error)}));
  compare_with_golden_file("cases.txt", text);
}

TEST_CASE("Where room is short, long results give way, then inputs, and a case keeps to its lines") {
  for (const auto& table : {every_kind(), every_comparison(), special()})
    for (const Shown& one : table)
      for (const std::size_t width : {44, 78}) {
        const Page page{.width = width, .is_brief = true, .most_lines = 9};
        const auto lines = describe_case(one.exercise, 0, one.actual, page);
        CAPTURE(joined(lines));
        CHECK_MESSAGE(lines.size() <= 9, one.about);
        CHECK(widest(lines) <= width);
      }
  Exercise crowded = given_results(Kind::vector3, {vector({1, 2, 3})});
  for (int k = 0; k < 12; ++k) {
    crowded.arguments.push_back({fmt::format("a_long_name_of_an_argument_{}", k), Kind::vector3, units::metre});
    crowded.cases[0].inputs.push_back(vector({1.0 / 3, 2.0 / 3, k / 7.0}));
  }
  const auto lines = describe_case(crowded, 0, vector({1, 2, 4}), {.is_brief = true, .most_lines = 10});
  CHECK(lines.size() == 10);
  CHECK(has(joined(lines), "(further inputs not shown)"));
  CHECK(has(lines.back(), "[2]   3        ≠ 4"));
}

TEST_CASE("Every number that differs, and no other, is marked") {
  for (const Shown& one : every_kind()) {
    const Value& expected = one.exercise.cases[0].expected;
    std::ptrdiff_t differing = 0;
    for (std::size_t n = 0; n < expected.numbers.size(); ++n)
      if (one.actual->numbers[n] != expected.numbers[n]) ++differing;
    CHECK_MESSAGE(marks(describe_case(one.exercise, 0, one.actual, {.is_linear = true})) == differing, one.about);
    CHECK_MESSAGE(marks(describe_case(one.exercise, 0, expected)) == 0, one.about);
  }
  const auto all = describe_case(mirrored(Kind::points, filled(3, 40, 1)), 0, filled(3, 40, 2), {.most_rows = 10000});
  CHECK(marks(all) == 120);
}

TEST_CASE("Every kind fits on the page, with all its digits") {
  for (const Shown& one : every_kind()) {
    for (double factor : {1.0, 1e-7, 1e9}) {
      const Value& like = one.exercise.cases[0].expected;
      const Value expected = lengthy(like.rows, like.cols, factor);
      Value wrong = expected;
      for (double& entry : wrong.numbers) entry = std::nextafter(entry, 0);
      Exercise exercise = mirrored(one.exercise.result_kind, expected, units::angular_momentum);
      exercise.cases[0].tolerance = 1e-20;
      const auto lines = describe_case(exercise, 0, wrong);
      CAPTURE(joined(lines));
      // Only three full numbers with exponents, and their column's number, need the margin too.
      CHECK(widest(lines) <= (factor == 1e-7 ? 80 : 78));
      CHECK(marks(lines) > 0);
    }
  }
}

}  // namespace workbook::testing
