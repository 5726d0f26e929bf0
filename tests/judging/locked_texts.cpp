// Texts that a right function opens, and no other one.
#include "checker/course/locked_text.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace workbook::testing {
namespace {

/// x ↦ 7 sin x at ten inputs.
ExerciseReference sine(Comparison comparison) {
  std::vector<Value> expected;
  expected.reserve(10);
  for (int i = 0; i < 10; ++i) expected.push_back(number(7 * std::sin(0.37 * i + 0.1)));
  ExerciseReference exercise = given_results(Kind::number, expected);
  exercise.comparison = comparison;
  exercise.arguments = {{"x", Kind::number, units::none}};
  for (int i = 0; i < 10; ++i) {
    exercise.cases[static_cast<std::size_t>(i)].inputs = {number(0.37 * i + 0.1)};
    exercise.cases[static_cast<std::size_t>(i)].scale = {7};
  }
  return exercise;
}

std::optional<std::string> opened(const std::string& locked, const std::function<double(double)>& function) {
  std::vector<Reply> replies;
  for (const PlannedCall& call : calls_of_locked(locked))
    replies.push_back(returning(number(function(call.inputs[0].numbers[0]))));
  return unlocked_text(locked, replies);
}

double right(double x) { return 7 * std::sin(x); }

}  // namespace

TEST_CASE("a right function opens the text, in any rounding, and the text does not stand there in clear") {
  const std::string locked = locked_text(sine(Comparison::plain), "the derivation");
  CHECK(locked.find("derivation") == std::string::npos);
  CHECK(opened(locked, right) == "the derivation");
  CHECK(opened(locked, [](double x) { return right(x) * (1 + 1e-9); }) == "the derivation");
  CHECK(locked != locked_text(sine(Comparison::plain), "the derivation"));  // another salt each time
}

TEST_CASE("a wrong function opens nothing") {
  const std::string locked = locked_text(sine(Comparison::plain), "the derivation");
  CHECK(!opened(locked, [](double x) { return -right(x); }));
  CHECK(!opened(locked, [](double x) { return right(x) * 1.001; }));
  CHECK(!opened(locked, [](double) { return std::nan(""); }));
  CHECK(!unlocked_text(locked, std::vector<Reply>(calls_of_locked(locked).size())));
  CHECK(!unlocked_text(locked, {}));
}

TEST_CASE("the freedom of a comparison is no hindrance") {
  CHECK(opened(locked_text(sine(Comparison::up_to_sign), "text"), [](double x) { return -right(x); }) == "text");
  const double turn = 2 * std::acos(-1.0);
  CHECK(opened(locked_text(sine(Comparison::attitude_by_angles), "text"), [=](double x) { return right(x) + turn; }) ==
        "text");
}

TEST_CASE("whole numbers make a key only by many calls, counted by the most frequent one, and their order is no help") {
  const auto signs = [](int count) {
    std::vector<Value> expected;
    for (int i = 0; i < count; ++i) expected.push_back(number(i % 3 == 0 ? -1 : 1));
    ExerciseReference exercise = given_results(Kind::integer, expected);
    exercise.arguments = {{"i", Kind::integer, units::none}};
    for (int i = 0; i < count; ++i) exercise.cases[static_cast<std::size_t>(i)].inputs = {number(i)};
    return exercise;
  };
  const auto sign = [](double i) { return std::fmod(i, 3) == 0 ? -1.0 : 1.0; };
  CHECK(!makes_key(signs(81)));  // log2(3/2) = 0.585 bits a call
  CHECK_THROWS_AS(locked_text(signs(81), "text"), std::runtime_error);
  CHECK(makes_key(signs(84)));
  CHECK(!makes_key(given_results(Kind::integer, std::vector<Value>(1000, number(1)))));
  const std::string locked = locked_text(signs(84), "text");
  CHECK(opened(locked, sign) == "text");
  CHECK(!opened(locked, [&](double i) { return i == 42 ? -sign(i) : sign(i); }));
  CHECK(nlohmann::json::parse(locked)["calls"] != nlohmann::json::parse(locked_text(signs(84), "text"))["calls"]);
}

TEST_CASE("a damaged text is named, and too few cases make no key") {
  std::string locked = locked_text(sine(Comparison::plain), "the derivation");
  CHECK_THROWS_AS(opened(locked.substr(0, locked.size() / 2), right), std::runtime_error);
  CHECK_THROWS_AS(opened("{}", right), std::runtime_error);
  ExerciseReference few = sine(Comparison::plain);
  few.cases.resize(1);
  CHECK_THROWS_AS(locked_text(few, "text"), std::runtime_error);
}

}  // namespace workbook::testing
