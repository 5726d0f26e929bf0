// Values and units: as JSON, and as people read them.
#include "checker/base/superscript.hpp"
#include "checker/data/unit.hpp"
#include "checker/judging/value_text.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace workbook::testing {
namespace {

struct Written {
  Kind kind;
  Value value;
  std::string json;
};

const std::vector<Written> written = {
    {Kind::number, number(0.1), "0.1"},
    {Kind::number, number(-0.0), "-0.0"},
    {Kind::number, number(5e-324), "5e-324"},
    {Kind::integer, number(-1), "-1"},
    {Kind::vector2, vector({1, 2}), "[1.0,2.0]"},
    {Kind::vector3, vector({1, 2, 3}), "[1.0,2.0,3.0]"},
    {Kind::vector, vector({}), "[]"},
    {Kind::vector, vector({1, 2, 3, 4}), "[1.0,2.0,3.0,4.0]"},
    {Kind::matrix3, three_rows({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}), "[[1.0,2.0,3.0],[4.0,5.0,6.0],[7.0,8.0,9.0]]"},
    {Kind::points, three_rows({{1, 2}, {3, 4}, {5, 6}}), "[[1.0,2.0],[3.0,4.0],[5.0,6.0]]"},
    {Kind::points, three_rows({{}, {}, {}}), "[[],[],[]]"},
    {Kind::matrices, {3, 0, {}}, "[]"},
    {Kind::matrices, three_rows({{1, 0, 0, 4, 0, 0}, {0, 2, 0, 0, 5, 7}, {0, 0, 3, 0, 0, 6}}),
     "[[[1.0,0.0,0.0],[0.0,2.0,0.0],[0.0,0.0,3.0]],[[4.0,0.0,0.0],[0.0,5.0,7.0],[0.0,0.0,6.0]]]"},
};

struct Refused {
  Kind kind;
  std::string json;
  std::string reason;
};

const std::vector<Refused> refused = {
    {Kind::number, R"("1")", "expected a number, found string"},
    {Kind::number, "[1]", "expected a number, found array"},
    {Kind::number, "true", "expected a number, found boolean"},
    {Kind::integer, "0.5", "expected a whole number, found 0.5"},
    {Kind::vector2, "[1,2,3]", "expected a list of 2 numbers, found a list of 3"},
    {Kind::vector3, "[1,2]", "expected a list of 3 numbers, found a list of 2"},
    {Kind::vector3, "7", "expected a list of 3 numbers, found number"},
    {Kind::vector, "{}", "expected a list of numbers, found object"},
    {Kind::vector, "[[1]]", "expected a number, found array"},
    {Kind::matrix3, "[[1,2,3],[1,2,3]]", "expected a list of 3 rows, found a list of 2"},
    {Kind::matrix3, "[[1,2,3],[1,2,3],[1,2]]", "expected a row of 3 numbers, found a list of 2"},
    {Kind::matrix3, "[[1,2],[1,2],[1,2]]", "expected 3 rows of 3 numbers, found rows of 2"},
    {Kind::points, "[[1,2],[1,2],[1]]", "expected a row of 2 numbers, found a list of 1"},
    {Kind::points, "[1,2,3]", "expected a list of 3 rows, found number"},
    {Kind::matrices, "[[1,2,3]]", "expected a list of 3 rows, found number"},
    {Kind::matrices, "3", "expected a list of 3×3 matrices, found number"},
};

}  // namespace

TEST_CASE("A value of every kind is written to JSON and read back the same") {
  for (const Written& one : written) {
    CAPTURE(one.json);
    CHECK(to_json(one.value, one.kind).dump() == one.json);
    CHECK(value_from_json(nlohmann::json::parse(one.json), one.kind) == one.value);
  }
}

TEST_CASE("Numbers that JSON cannot hold become null, and null becomes NaN") {
  CHECK(to_json(vector({not_a_number, infinity, 1}), Kind::vector3).dump() == "[null,null,1.0]");
  const Value read = value_from_json(nlohmann::json::parse("[null,2,1]"), Kind::vector3);
  CHECK(std::isnan(read.numbers[0]));
  CHECK(read.numbers[1] == 2);
  CHECK(to_json(number(not_a_number), Kind::integer).is_null());
}

TEST_CASE("JSON of the wrong type or shape is refused, and the reason says what was found") {
  for (const Refused& one : refused) {
    CAPTURE(one.json);
    CHECK_THROWS_WITH_AS(value_from_json(nlohmann::json::parse(one.json), one.kind), one.reason.c_str(),
                         std::invalid_argument);
  }
}

TEST_CASE("Every kind has a name, and an unknown name is refused") {
  for (const Written& one : written) CHECK(kind_from_string(to_string(one.kind)) == one.kind);
  CHECK_THROWS_WITH_AS(kind_from_string("tensor"), "unknown kind “tensor”", std::invalid_argument);
}

TEST_CASE("Only values without NaN and infinity are finite") {
  CHECK(is_finite(vector({1, -2})));
  CHECK(is_finite(vector({})));
  CHECK_FALSE(is_finite(vector({1, not_a_number})));
  CHECK_FALSE(is_finite(vector({-infinity, 1})));
}

TEST_CASE("Units are written with raised exponents and one slash") {
  CHECK(to_string(units::none).empty());
  CHECK(to_string(units::metre) == "m");
  CHECK(to_string(units::moment_of_inertia) == "kg m²");
  CHECK(to_string(units::angular_momentum) == "kg m²/s");
  CHECK(to_string(units::radian_per_second_squared) == "rad/s²");
  CHECK(to_string(units::none / units::second) == "1/s");
  CHECK(to_string(units::none / units::second / units::second) == "1/s²");
  CHECK(to_string(units::kilogram / (units::metre * units::second)) == "kg/(m s)");
  CHECK(to_string(units::joule) == "kg m²/s²");
}

TEST_CASE("Exponents are raised digit by digit") {
  CHECK(superscript(4) == "⁴");
  CHECK(superscript(-10) == "⁻¹⁰");
}

TEST_CASE("A value is shown on one line in the way of its kind") {
  CHECK(format_value(number(4.82), Kind::number) == "4.82");
  CHECK(format_value(number(1.0 / 3), Kind::number) == "0.3333333333333333");
  CHECK(format_value(number(1.0 / 3), Kind::number, 3) == "0.333");
  CHECK(format_value(number(-1), Kind::integer) == "-1");
  CHECK(format_value(vector({0.3, -0.2, 0.5}), Kind::vector3) == "(0.3, -0.2, 0.5)");
  CHECK(format_value(vector({}), Kind::vector) == "()");
  CHECK(format_value(three_rows({{26, -3, -4.5}, {-3, 20, -9}, {-4.5, -9, 10}}), Kind::matrix3) ==
        "[26 -3 -4.5; -3 20 -9; -4.5 -9 10]");
  CHECK(format_value(three_rows({{1, 2}, {3, 4}, {5, 6}}), Kind::points) == "[1 2; 3 4; 5 6]");
  CHECK(format_value(three_rows({{}, {}, {}}), Kind::points) == "[]");
  CHECK(format_value(three_rows({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), Kind::matrices) == "{[1 0 0; 0 1 0; 0 0 1]}");
}

TEST_CASE("A number has no sign when it is zero or not a number") {
  CHECK(number_text(-0.0, 6) == "0");
  CHECK(number_text(-not_a_number, 6) == "NaN");
  CHECK(number_text(-infinity, 6) == "-inf");
}

TEST_CASE("Two numbers are shown with as many digits as tell them apart") {
  CHECK(distinct_texts(1, 2, 6) == std::pair<std::string, std::string>("1", "2"));
  CHECK(distinct_texts(1, 1 + 1e-9, 6) == std::pair<std::string, std::string>("1", "1.000000001"));
  CHECK(distinct_texts(1, 1, 6) == std::pair<std::string, std::string>("1", "1"));
  CHECK(digits_to_tell_apart(1, 2) == 6);
  CHECK(digits_to_tell_apart(1, 1 + 1e-9) == 11);
  CHECK(digits_to_tell_apart(1, std::nextafter(1, 2)) == 17);
  CHECK(digits_to_tell_apart(1, not_a_number) == 6);
}

TEST_CASE("A coefficient is shown as the simple fraction that it is") {
  CHECK(coefficient_text(0.5) == "1/2");
  CHECK(coefficient_text(-1 + 1e-9) == "−1");
  CHECK(coefficient_text(1e-9) == "0");
  CHECK(coefficient_text(-1e-9) == "0");
  CHECK(coefficient_text(-4.0 / 3) == "−4/3");
  CHECK(coefficient_text(12) == "12");
  CHECK(coefficient_text(3.14159265) == "3.142");
}

TEST_CASE("A number of a value is named as one counts, from 1") {
  CHECK(entry_name(number(1), Kind::number, 0) == "the result");
  CHECK(entry_name(vector({1, 2, 3}), Kind::vector3, 1) == "component 2");
  CHECK(entry_name({3, 3, std::vector<double>(9)}, Kind::matrix3, 3) == "entry (1,2)");
  CHECK(entry_name({3, 6, std::vector<double>(18)}, Kind::matrices, 17) == "entry (3,3) of matrix 2");
}

TEST_CASE("Numbers stand with their decimal points below each other, whatever their width") {
  CHECK(aligned_on_point({"1.5", "-20", "3e-05", "NaN"}) ==
        std::vector<std::string>{"  1.5  ", "-20    ", "  3e-05", "NaN    "});
  CHECK(display_width("≠ m²") == 4);
}

}  // namespace workbook::testing
