// Values and units: as JSON, and as people read them.
#include "checker/data/unit.hpp"
#include "checker/data/value.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace workbook::testing {
namespace {

using nlohmann::json;

struct Written {
  Kind kind;
  Value value;
  std::string shown;
  std::string stored;         ///< in the reference results
  std::string reported = "";  ///< in reports, where it differs
};

const std::vector<Written> written = {
    {Kind::number, number(1.0 / 3), "0.3333333333333333", "0.3333333333333333"},
    {Kind::number, number(-0.0), "0", "-0.0"},
    {Kind::number, number(5e-324), "5e-324", "5e-324"},
    {Kind::integer, number(-1), "-1", "-1.0", "-1"},
    {Kind::vector2, vector({1, 2}), "(1, 2)", "[1.0,2.0]"},
    {Kind::vector3, vector({0.3, -0.2, 3}), "(0.3, -0.2, 3)", "[0.3,-0.2,3.0]"},
    {Kind::vector, vector({}), "()", "[]"},
    {Kind::vector, vector({1}), "(1)", "1.0", "[1.0]"},
    {Kind::vector, vector({1, 2, 3, 4}), "(1, 2, 3, 4)", "[1.0,2.0,3.0,4.0]"},
    {Kind::matrix3, diagonal(1, 2, 3), "[1 0 0; 0 2 0; 0 0 3]", "[[1.0,0.0,0.0],[0.0,2.0,0.0],[0.0,0.0,3.0]]"},
    {Kind::points, three_rows({{1, 2}, {3, 4}, {5, 6}}), "[1 2; 3 4; 5 6]", "[[1.0,2.0],[3.0,4.0],[5.0,6.0]]"},
    {Kind::points, three_rows({{1}, {3}, {5}}), "[1; 3; 5]", "[1.0,3.0,5.0]", "[[1.0],[3.0],[5.0]]"},
    {Kind::points, three_rows({{}, {}, {}}), "[]", "[[],[],[]]"},
    {Kind::matrices, {3, 0, {}}, "{}", "[[],[],[]]", "[]"},
    {Kind::matrices, three_rows({{1, 0, 0, 4, 0, 0}, {0, 2, 0, 0, 5, 7}, {0, 0, 3, 0, 0, 6}}),
     "{[1 0 0; 0 2 0; 0 0 3], [4 0 0; 0 5 7; 0 0 6]}",
     "[[1.0,0.0,0.0,4.0,0.0,0.0],[0.0,2.0,0.0,0.0,5.0,7.0],[0.0,0.0,3.0,0.0,0.0,6.0]]",
     "[[[1.0,0.0,0.0],[0.0,2.0,0.0],[0.0,0.0,3.0]],[[4.0,0.0,0.0],[0.0,5.0,7.0],[0.0,0.0,6.0]]]"},
};

}  // namespace

TEST_CASE("A value of every kind is shown on one line, written to JSON and read back the same") {
  for (const Written& one : written) {
    CAPTURE(one.stored);
    CHECK(format_value(one.value, one.kind) == one.shown);
    CHECK(json(one.value).dump() == one.stored);
    CHECK(json::parse(one.stored).get<Value>() == one.value);
    CHECK(json_of(one.value, one.kind).dump() == (one.reported.empty() ? one.stored : one.reported));
    CHECK(kind_from_string(to_string(one.kind)) == one.kind);
  }
  CHECK_THROWS_AS(kind_from_string("tensor"), std::invalid_argument);
}

TEST_CASE("Numbers that JSON cannot hold become null, and null becomes NaN") {
  CHECK(json(vector({not_a_number, infinity, 1})).dump() == "[null,null,1.0]");
  const auto value = json::parse("[null,2,1]").get<Value>();
  CHECK(std::isnan(value.numbers[0]));
  CHECK(value.numbers[1] == 2);
  CHECK_FALSE(value.is_finite());
  CHECK_FALSE(number(-infinity).is_finite());
  CHECK(json_of(number(not_a_number), Kind::integer).is_null());
}

TEST_CASE("JSON that is no value is refused") {
  for (const char* text : {R"("1")", "true", "{}", R"([1,"2"])", "[[1,2],[1]]", "[[1],2]", "[[[1]]]", "[1,[2]]"})
    CHECK_THROWS_AS(json::parse(text).get<Value>(), std::exception);
}

TEST_CASE("Units are written with raised exponents and one slash") {
  CHECK(to_string(units::none).empty());
  CHECK(to_string(units::angular_momentum) == "kg m²/s");
  CHECK(to_string(units::none / units::second) == "1/s");
  CHECK(to_string(units::kilogram / (units::metre * units::second)) == "kg/(m s)");
  CHECK(to_string(units::radian_per_second_squared) == "rad/s²");
}

TEST_CASE("Numbers are shown with as many digits as are needed, and no sign where it says nothing") {
  CHECK(number_text(1.0 / 3, 3) == "0.333");
  CHECK(number_text(-not_a_number, 6) == "NaN");
  CHECK(number_text(-infinity, 6) == "-inf");
  CHECK(distinct_texts(1, 1 + 1e-9, 6) == std::pair<std::string, std::string>("1", "1.000000001"));
  CHECK(digits_to_tell_apart(1, 1 + 1e-9) == 11);
  CHECK(digits_to_tell_apart(1, std::nextafter(1, 2)) == 17);
  CHECK(digits_to_tell_apart(1, not_a_number) == 6);
  CHECK(coefficient_text(-4.0 / 3) == "−4/3");
  CHECK(coefficient_text(-1e-9) == "0");
  CHECK(coefficient_text(3.14159265) == "3.142");
}

}  // namespace workbook::testing
