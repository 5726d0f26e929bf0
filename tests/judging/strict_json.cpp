// JSON in which a key stands twice is refused with its place; all else is read as the library reads it.
#include "checker/data/strict_json.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace workbook::testing {
namespace {

using nlohmann::json;

/// What parse_strictly says; empty if it has nothing to say.
std::string complaint(const std::string& text) {
  try {
    parse_strictly(text);
    return "";
  } catch (const RepeatedKey& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("A key that stands twice in one object is refused with its place") {
  struct Repetition {
    const char* text;
    const char* complaint;
  };
  const Repetition repetitions[] = {
      {R"({"a": 1, "a": 1})", "top level: the key “a” stands here twice"},
      {R"({"a": {"b": 1, "c": {}, "b": 2}})", "a: the key “b” stands here twice"},
      {R"({"a": [1, [2], {"b": 3}, {"c": [{"d": 4}], "e": {"f": 5, "f": 6}}]})",
       "a[3].e: the key “f” stands here twice"},
      {R"([[{}, {"a": 1, "a": 1}]])", "[0][1]: the key “a” stands here twice"},
      {R"({"a": {"x": 1}, "b": {"x": 1}, "a": 2})", "top level: the key “a” stands here twice"},
      {R"({"a": 1, "\u0061": 2})", "top level: the key “a” stands here twice"},
  };
  for (const Repetition& repetition : repetitions) {
    CAPTURE(repetition.text);
    CHECK(complaint(repetition.text) == repetition.complaint);
  }
}

TEST_CASE("A key may stand once in each of many objects") {
  const std::string text = R"({"a": [{"a": 1}, {"a": {"a": [], "b": null}}], "b": -2.5e-3, "c": "a"})";
  CHECK(parse_strictly(text) == json::parse(text));
  CHECK(parse_strictly("7") == 7);
}

TEST_CASE("What is not JSON is the library's error, also without any text") {
  CHECK_THROWS_AS(parse_strictly(""), json::parse_error);
  CHECK_THROWS_AS(parse_strictly(R"({"a": })"), json::parse_error);
  CHECK_THROWS_AS(parse_strictly("1e999"), json::out_of_range);
}

}  // namespace workbook::testing
