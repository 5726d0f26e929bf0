// Files of reference results: what is written is read back, and whatever is wrong with a file is said with its place.
#include "checker/data/reference_json.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

namespace workbook::testing {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path scratch_file(const std::string& name) {
  const fs::path folder = WORKBOOK_TEST_SCRATCH;
  fs::create_directories(folder);
  return folder / name;
}

void write_text(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// What reading the file says; empty if it is read.
std::string complaint(const fs::path& file) {
  try {
    read_reference_results(file);
    return "";
  } catch (const ReferenceError& error) {
    return error.what();
  }
}

LectureReference sound_lecture() {
  LectureReference lecture;
  lecture.seed = 18446744073709551615u;
  lecture.lecture = "99_made_up";
  lecture.exercises = {sound_momentum(), given_results(Kind::matrix3, {three_rows({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})})};
  lecture.exercises[0].tolerance_reason = "none";

  ExerciseReference& second = lecture.exercises[1];
  second.arguments[0].kind = Kind::matrix3;
  second.cases[0].inputs[0] = second.cases[0].expected;
  second.comparison = Comparison::eigenvectors;
  second.properties = {{PropertyKind::rotation_matrix, "It is a rotation.", "anchor", -1, {}},
                       {PropertyKind::constant_weighted_square, "It is constant.", "anchor", -1, {{1, 2, 3}}}};
  lecture.exercises[0].properties = {{PropertyKind::orthogonal_to_argument, "It is perpendicular.", "anchor", 2, {}}};
  return lecture;
}

struct Damage {
  std::string about;
  std::function<void(json&)> apply;
  std::string complaint;
};

json& exercise(json& document) { return document["exercises"][0]; }
json& first_case(json& document) { return exercise(document)["cases"][0]; }

const std::vector<Damage> damages = {
    {"an older format", [](json& d) { d["format"] = 0; },
     "format: this file has format 0, this checker reads format 1"},
    {"a newer format with other keys",
     [](json& d) {
       d = {{"format", 2}};
     },
     "format: this file has format 2, this checker reads format 1"},
    {"no format", [](json& d) { d.erase("format"); }, "top level: the key “format” is missing"},
    {"not an object", [](json& d) { d = json::array(); }, "top level: the key “format” is missing"},
    {"a missing key", [](json& d) { first_case(d).erase("scale"); },
     "exercises[0].cases[0]: the key “scale” is missing"},
    {"an unknown key", [](json& d) { d["sed"] = 1; }, "top level: the key “sed” is unknown"},
    {"an object that is a list", [](json& d) { exercise(d)["result"] = json::array(); },
     "exercises[0].result: expected an object, found array"},
    {"a list that is an object", [](json& d) { exercise(d)["cases"] = json::object(); },
     "exercises[0].cases: expected a list, found object"},
    {"a name that is a number", [](json& d) { exercise(d)["name"] = 3; },
     "exercises[0].name: expected a string, found number"},
    {"an empty name", [](json& d) { first_case(d)["name"] = ""; }, "exercises[0].cases[0].name: must not be empty"},
    {"a negative seed", [](json& d) { d["seed"] = -1; }, "seed: expected a natural number, found -1"},
    {"a truth that is a number", [](json& d) { first_case(d)["deciding"] = 1; },
     "exercises[0].cases[0].deciding: expected true or false, found number"},
    {"an unknown kind", [](json& d) { exercise(d)["result"]["kind"] = "tensor"; },
     "exercises[0].result.kind: unknown kind “tensor”"},
    {"an unknown group", [](json& d) { first_case(d)["group"] = "easy"; },
     "exercises[0].cases[0].group: “easy” is not one of the known choices"},
    {"an unknown comparison", [](json& d) { exercise(d)["comparison"] = "loose"; },
     "exercises[0].comparison: “loose” is not one of the known choices"},
    {"an unknown unit",
     [](json& d) {
       exercise(d)["arguments"][0]["unit"] = {{"lb", 1}};
     },
     "exercises[0].arguments[0].unit: the key “lb” is unknown"},
    {"half an exponent",
     [](json& d) {
       exercise(d)["arguments"][0]["unit"] = {{"m", 0.5}};
     },
     "exercises[0].arguments[0].unit.m: expected a whole number, found 0.5"},
    {"no unit of the result", [](json& d) { exercise(d)["result"]["units"] = json::array(); },
     "exercises[0].result.units: expected at least one unit, found none"},
    {"units that do not fit the result",
     [](json& d) {
       exercise(d)["result"]["units"] = {json::object(), json::object()};
     },
     "exercises[0].cases[0].expected: the result has 2 units but 3 numbers"},
    {"an argument without an input", [](json& d) { first_case(d)["inputs"].erase(2); },
     "exercises[0].cases[0].inputs: expected 3 items (one per argument), found 2"},
    {"an input of another shape",
     [](json& d) {
       first_case(d)["inputs"][1] = {1, 2};
     },
     "exercises[0].cases[0].inputs[1]: expected a list of 3 numbers, found a list of 2"},
    {"an input that is null", [](json& d) { first_case(d)["inputs"][0] = nullptr; },
     "exercises[0].cases[0].inputs[0]: every number here must be finite, found null"},
    {"an expected null", [](json& d) { first_case(d)["expected"][1] = nullptr; },
     "exercises[0].cases[0].expected: every number here must be finite, found null"},
    {"an expected text", [](json& d) { first_case(d)["expected"][1] = "1"; },
     "exercises[0].cases[0].expected: expected a number, found string"},
    {"another number of expected ones",
     [](json& d) {
       first_case(d)["expected"] = {1, 2};
     },
     "exercises[0].cases[0].expected: expected a list of 3 numbers, found a list of 2"},
    {"a scale of zero", [](json& d) { first_case(d)["scale"] = {0}; },
     "exercises[0].cases[0].scale[0]: expected a positive number, found 0"},
    {"a negative scale",
     [](json& d) {
       first_case(d)["scale"] = {1, -2, 1};
     },
     "exercises[0].cases[0].scale[1]: expected a positive number, found -2"},
    {"a scale that is not a number", [](json& d) { first_case(d)["scale"] = {nullptr}; },
     "exercises[0].cases[0].scale[0]: every number here must be finite, found null"},
    {"too few scales",
     [](json& d) {
       first_case(d)["scale"] = {1, 1};
     },
     "exercises[0].cases[0].scale: expected 1 or 3 numbers, found 2"},
    {"a tolerance of zero", [](json& d) { first_case(d)["tolerance"] = 0; },
     "exercises[0].cases[0].tolerance: expected a positive number, found 0"},
    {"no cases", [](json& d) { exercise(d)["cases"] = json::array(); }, "exercises[0].cases: an exercise needs cases"},
    {"two cases of one name", [](json& d) { exercise(d)["cases"][2]["name"] = "generic 1"; },
     "exercises[0].cases[2].name: the name “generic 1” stands here twice"},
    {"two exercises of one name", [](json& d) { d["exercises"][1]["name"] = "momentum"; },
     "exercises[1].name: the name “momentum” stands here twice"},
    {"two misconceptions of one name", [](json& d) { exercise(d)["misconceptions"][1]["name"] = "no_two"; },
     "exercises[0].misconceptions[1].name: the name “no_two” stands here twice"},
    {"two terms of one name", [](json& d) { exercise(d)["terms"][1]["name"] = "m u"; },
     "exercises[0].terms[1].name: the name “m u” stands here twice"},
    {"too few outputs of a misconception", [](json& d) { exercise(d)["misconceptions"][0]["outputs"].erase(0); },
     "exercises[0].misconceptions[0].outputs: expected 9 items (one per case), found 8"},
    {"too few outputs over the sweep", [](json& d) { exercise(d)["misconceptions"][0]["sweep_outputs"].erase(0); },
     "exercises[0].misconceptions[0].sweep_outputs: expected 2 items (one per point of the sweep), found 1"},
    {"a misconception without a message", [](json& d) { exercise(d)["misconceptions"][0]["message"] = ""; },
     "exercises[0].misconceptions[0].message: must not be empty"},
    {"too many outputs of a term",
     [](json& d) {
       exercise(d)["terms"][0]["outputs"].push_back({1, 2, 3});
     },
     "exercises[0].terms[0].outputs: expected 9 items (one per case), found 10"},
    {"a term that is null",
     [](json& d) {
       exercise(d)["terms"][0]["outputs"][3] = {1, nullptr, 3};
     },
     "exercises[0].terms[0].outputs[3]: every number here must be finite, found null"},
    {"a coefficient that is a text", [](json& d) { exercise(d)["terms"][0]["coefficient"] = "2"; },
     "exercises[0].terms[0].coefficient: expected a number, found string"},
    {"a route that is null",
     [](json& d) {
       exercise(d)["routes"][2]["outputs"][0] = {nullptr, 1, 1};
     },
     "exercises[0].routes[2].outputs[0]: every number here must be finite, found null"},
    {"an unknown property", [](json& d) { exercise(d)["properties"][0]["kind"] = "nice"; },
     "exercises[0].properties[0].kind: “nice” is not one of the known choices"},
    {"a property of other results",
     [](json& d) {
       exercise(d)["properties"][0] = {{"kind", "symmetric"}, {"message", "a"}, {"notes", ""}};
     },
     "exercises[0].properties[0].kind: a result of kind vector3 cannot be symmetric"},
    {"no such argument", [](json& d) { exercise(d)["properties"][0]["argument"] = 3; },
     "exercises[0].properties[0].argument: there is no such argument"},
    {"an argument of another kind", [](json& d) { exercise(d)["properties"][0]["argument"] = 0; },
     "exercises[0].properties[0].argument: the argument is not of the kind of the result"},
    {"too few weights", [](json& d) { d["exercises"][1]["properties"][1]["weights"][0].erase(0); },
     "exercises[1].properties[1].weights[0]: expected 3 items (one per row), found 2"},
    {"weights of other cases",
     [](json& d) {
       d["exercises"][1]["properties"][1]["weights"].push_back({1, 2, 3});
     },
     "exercises[1].properties[1].weights: expected 1 item (one per case), found 2"},
    {"eigenvectors of a number", [](json& d) { exercise(d)["comparison"] = "eigenvectors"; },
     "exercises[0].comparison: eigenvectors need a matrix3 as result and as first argument"},
    {"an attitude by nine angles", [](json& d) { d["exercises"][1]["comparison"] = "attitude_by_angles"; },
     "exercises[1].cases[0].expected: attitudes are compared by 3 angles"},
    {"a sweep without points", [](json& d) { exercise(d)["sweep"]["x"] = json::array(); },
     "exercises[0].sweep.x: a sweep needs points"},
    {"a sweep with a missing input", [](json& d) { exercise(d)["sweep"]["inputs"].erase(0); },
     "exercises[0].sweep.inputs: expected 2 items (one per point of the sweep), found 1"},
    {"a component that the result does not have", [](json& d) { exercise(d)["sweep"]["components"][0]["row"] = 3; },
     "exercises[0].sweep.components[0]: the result has no such row and column"},
};

}  // namespace

TEST_CASE("Reference results that are written are read back the same, to the last digit") {
  const LectureReference lecture = sound_lecture();
  const fs::path file = scratch_file("round_trip.json");
  write_reference_results(lecture, file);
  const LectureReference read = read_reference_results(file);

  CHECK(read.seed == lecture.seed);
  CHECK(read.lecture == lecture.lecture);
  CHECK(readable_text(lecture_to_json(read)) == readable_text(lecture_to_json(lecture)));
  REQUIRE(read.exercises.size() == 2);
  const ExerciseReference& momentum_read = read.exercise("momentum");
  for (std::size_t i = 0; i < momentum_read.cases.size(); ++i) {
    CHECK(momentum_read.cases[i].expected == lecture.exercises[0].cases[i].expected);
    CHECK(momentum_read.cases[i].inputs == lecture.exercises[0].cases[i].inputs);
    CHECK(momentum_read.cases[i].scale == lecture.exercises[0].cases[i].scale);
    CHECK(momentum_read.cases[i].group == lecture.exercises[0].cases[i].group);
    CHECK(momentum_read.cases[i].deciding == lecture.exercises[0].cases[i].deciding);
  }
  CHECK(momentum_read.result_units == lecture.exercises[0].result_units);
  CHECK(momentum_read.arguments[1].unit == units::metre_per_second);
  CHECK(momentum_read.terms[1].coefficient == 2);
  CHECK(momentum_read.properties[0].argument == 2);
  CHECK(momentum_read.sweep.components[0].name == "p_x");
  CHECK(read.exercises[1].comparison == Comparison::eigenvectors);
  CHECK(read.exercises[1].properties[1].weights[0] == std::vector<double>{1, 2, 3});
}

TEST_CASE("Only wrong answers may hold NaN: it survives as null") {
  LectureReference lecture = sound_lecture();
  lecture.exercises[0].misconceptions[0].outputs[0].numbers[1] = infinity;
  const fs::path file = scratch_file("with_null.json");
  write_reference_results(lecture, file);
  CHECK(contains(text_of(file), "null"));
  CHECK(std::isnan(read_reference_results(file).exercises[0].misconceptions[0].outputs[0].numbers[1]));
}

TEST_CASE("A value stands on one line where it fits") {
  const std::string text = readable_text(lecture_to_json(sound_lecture()));
  CHECK(contains(text, "\n          \"expected\": [4.0, 0.0, 22.0],\n"));
  CHECK(contains(text, "\n          \"inputs\": [2.0, [1.0, 2.0, 3.0], [0.5, -1.0, 4.0]],\n"));
}

TEST_CASE("Whatever is wrong with a file is said with file, place and reason") {
  const json sound = json::parse(readable_text(lecture_to_json(sound_lecture())));
  const fs::path file = scratch_file("damaged.json");
  for (const Damage& damage : damages) {
    CAPTURE(damage.about);
    json damaged = sound;
    damage.apply(damaged);
    write_text(file, damaged.dump());
    CHECK(complaint(file) == file.string() + ": " + damage.complaint);
  }
}

TEST_CASE("A file cut off anywhere is refused, and the sentence says that it is truncated") {
  const std::string text = readable_text(lecture_to_json(sound_lecture()));
  const fs::path file = scratch_file("truncated.json");
  for (std::size_t length : {text.size() / 3, text.size() / 2, text.size() - 3}) {
    write_text(file, text.substr(0, length));
    CHECK(contains(complaint(file), file.string() + ": line "));
    CHECK(contains(complaint(file), "the file ends too early: it is truncated"));
  }
  write_text(file, "");
  CHECK(complaint(file) == file.string() + ": line 1, column 1: the file ends too early: it is truncated");
}

TEST_CASE("A file that is not JSON is refused at line and column") {
  const fs::path file = scratch_file("not_json.json");
  write_text(file, "{\n  \"format\": one\n}\n");
  CHECK(complaint(file) == file.string() + ": line 2, column 13: this is not JSON");
}

TEST_CASE("A key that stands twice is refused: nobody could say which of the two counts") {
  const fs::path file = scratch_file("twice.json");
  std::string text = readable_text(lecture_to_json(sound_lecture()));
  text.insert(text.find("\"tolerance\""), "\"tolerance\": 1, ");
  write_text(file, text);
  CHECK(complaint(file) == file.string() + ": exercises[0].cases[0]: the key “tolerance” stands here twice");
}

TEST_CASE("A number too large for the machine is refused") {
  const fs::path file = scratch_file("too_large.json");
  write_text(file, "{\"format\": 1e999}");
  CHECK(complaint(file) == file.string() + ": whole file: it holds a number that is too large");
}

TEST_CASE("A file that is not there, or is a folder, cannot be read") {
  const fs::path missing = scratch_file("missing.json");
  CHECK(complaint(missing) == missing.string() + ": whole file: it cannot be read");
  const fs::path folder = scratch_file("folder.json");
  fs::create_directories(folder);
  CHECK(complaint(folder) == folder.string() + ": whole file: it cannot be read");
}

TEST_CASE("A file that cannot be written leaves the old one as it was, and no unfinished one") {
  const fs::path nowhere = scratch_file("no such folder") / "results.json";
  CHECK_THROWS_WITH_AS(write_reference_results(sound_lecture(), nowhere),
                       (nowhere.string() + ": whole file: it cannot be written").c_str(), ReferenceError);

  const fs::path occupied = scratch_file("occupied.json");
  fs::create_directories(occupied / "something");
  CHECK_THROWS_AS(write_reference_results(sound_lecture(), occupied), ReferenceError);
  CHECK(fs::exists(occupied / "something"));
  for (const auto& entry : fs::directory_iterator(occupied.parent_path())) {
    CHECK_FALSE(contains(entry.path().string(), "unfinished"));
  }
}

TEST_CASE("Asking a lecture for an exercise that it does not have is an error with both names") {
  CHECK(sound_lecture().exercise("momentum").name == "momentum");
  CHECK_THROWS_WITH_AS(sound_lecture().exercise("energy"),
                       "The reference results of 99_made_up hold no exercise “energy”.", ReferenceError);
}

}  // namespace workbook::testing
