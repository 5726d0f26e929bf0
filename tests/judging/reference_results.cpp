// Files of reference results: what is written is read back the same, a damaged file is never accepted, and their author
// is told what contradicts itself (golden/soundness.txt).
#include "checker/data/reference_results.hpp"

#include "checker/explain/values/soundness.hpp"
#include "tests/judging/made_up.hpp"
#include "tests/support/files.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace workbook::testing {
namespace {

namespace fs = std::filesystem;
using P = PropertyKind;

fs::path scratch_file(const std::string& name) {
  fs::create_directories(WORKBOOK_TEST_SCRATCH);
  return fs::path(WORKBOOK_TEST_SCRATCH) / name;
}

/// The action refuses with one sentence that holds the names.
void check_refused(const std::vector<std::string>& names, const std::function<void()>& action) {
  try {
    action();
    FAIL_CHECK("not refused");
  } catch (const ReferenceError& error) {
    const std::string sentence = error.what();
    CHECK(sentence.ends_with('.'));
    CHECK_FALSE(has(sentence, "\n"));
    for (const std::string& name : names) CHECK_MESSAGE(has(sentence, name), sentence);
  }
}

void check_unreadable(const fs::path& file) {
  check_refused({file.filename().string()}, [&] { read_reference_results(file); });
}

Exercise with(const std::vector<P>& properties, Exercise exercise) {
  for (P kind : properties) add_property(exercise, kind, "It is so.");
  return exercise;
}

Exercise angles() {
  Exercise e = with({P::unit_norm, P::orthogonal_to_argument},
                    given_results(Kind::vector3, {vector({1, 2, 3})}, Comparison::attitude_by_angles));
  e.arguments[0].kind = Kind::vector3;
  e.cases[0].inputs[0] = vector({0.1, 1.0 / 3, -5e-324});
  e.cases[0].scale = {1, 2, 1e-300};
  e.properties.back().argument = 0;
  e.result_units = {units::radian, units::radian_per_second, units::none};
  e.tolerance_reason = "The step of an integration — “2 %” of it.";
  return e;
}

Exercise whole_momentum() {
  Exercise e = sound_momentum();
  e.input_transforms = {{"swapped", "u and v exchanged", outputs(e, momentum_with(2, 1))}};
  add_generated(e, 3, 1, vector({7, 8, 9}), right_momentum);
  e.cases.back().entry = 2;
  e.limits = {{1, "At rest there is none."}};
  e.measured = {{"a cart", e.cases[0].inputs, {0.1, 0.2, 0.3}}};
  return e;
}

/// Every kind, comparison and property, an empty list of every kind of list, and the largest seed.
LectureReference lecture() {
  LectureReference all;
  all.seed = 18446744073709551615u;
  all.lecture = "99_made_up";
  all.exercises = {whole_momentum(),
                   angles(),
                   with({P::symmetric, P::antisymmetric, P::positive_semidefinite, P::rotation_matrix},
                        eigenvectors(diagonal(1, 2, 3), diagonal(1, 1, 1))),
                   conserved(),
                   given_results(Kind::points, {three_rows({{}, {}, {}})}),
                   given_results(Kind::vector, {vector({}), vector({1}), vector({1, 2, 3, 4})}, Comparison::up_to_sign),
                   given_results(Kind::matrices, {{3, 0, {}}, diagonal(1, 2, 3), {3, 6, std::vector<double>(18, 0.1)}}),
                   with({P::nonnegative}, given_results(Kind::number, {number(1e300)})),
                   given_results(Kind::integer, {number(-7)}),
                   with({P::ascending}, given_results(Kind::vector2, {vector({1, 2})}))};
  for (std::size_t k = 0; k < all.exercises.size(); ++k) all.exercises[k].name += std::to_string(k);
  return all;
}

struct Mistake {
  std::string about;
  std::function<void(Exercise&)> make;
  std::size_t sentences = 1;
};

Value at_rest_only(const Inputs& in) { return in[1] == vector({0, 0, 0}) ? vector({1, 0, 0}) : vector({0, 0, 0}); }

const std::vector<Mistake> mistakes = {
    {"no mistake", [](Exercise&) {}, 0},
    {"too few misconceptions", [](Exercise& e) { e.misconceptions.pop_back(); }},
    {"too few routes", [](Exercise& e) { e.routes.pop_back(); }},
    {"too few deciding cases",
     [](Exercise& e) { e.cases[0].deciding = e.cases[1].deciding = e.cases[2].deciding = false; }},
    {"no worked case", [](Exercise& e) { e.cases[0].group = Group::random; }},
    {"no sweep", [](Exercise& e) { e.sweep = {}; }},
    {"a case that rounding decides", [](Exercise& e) { e.cases[2].condition = 3; }},
    {"a misconception that is right", [](Exercise& e) { add_misconception(e, "right", "And yet.", right_momentum); }},
    {"two that are one", [](Exercise& e) { add_misconception(e, "again", "You add them once.", momentum_with(1, 1)); }},
    {"other outputs where it does not decide",
     [](Exercise& e) { e.misconceptions[0].outputs[8] = e.misconceptions[0].outputs[0]; }, 0},
    {"terms that do not add up", [](Exercise& e) { e.terms[1].outputs[3].numbers[0] += 1e-3; }},
    {"a term that is seen at rest only", [](Exercise& e) { add_term(e, "c", 5, at_rest_only); }, 2},
    {"dependent terms", [](Exercise& e) { add_term(e, "m (u + v)", 0, momentum_with(1, 1)); }},
    {"a route that is wrong", [](Exercise& e) { e.routes[1].outputs[2].numbers[0] += 1; }},
    {"a solution that is wrong",
     [](Exercise& e) {
       for (auto& one : e.cases)
         for (double& number : one.expected.numbers) number = -number;
     }},
    {"a property that right results lack", [](Exercise& e) { add_property(e, PropertyKind::ascending, "It ascends."); },
     7},
    {"expected values that do not pass", [](Exercise& e) { e = eigenvectors(diagonal(1, 2, 3), diagonal(1, 1, -1)); },
     6},
};

}  // namespace

TEST_CASE("Reference results are read back as they were written; of wrong answers NaN and infinity as NaN") {
  LectureReference written = lecture();
  const fs::path file = scratch_file("round_trip.json");
  write_reference_results(written, file);
  const LectureReference again = read_reference_results(file);
  CHECK(as_written(again) == read(file));
  CHECK(&again.exercise("momentum0") == again.exercises.data());
  LectureReference one = written;
  one.exercises.resize(1);
  CHECK(as_written(read_reference_results(file, "momentum0")) == as_written(one));
  check_refused({"99_made_up", "energy"}, [&] { again.exercise("energy"); });

  written.exercises[0].misconceptions[0].outputs[0] = vector({not_a_number, infinity, 2});
  write_reference_results(written, file);
  const Value value = read_reference_results(file).exercises[0].misconceptions[0].outputs[0];
  CHECK(std::isnan(value.numbers[0]));
  CHECK(std::isnan(value.numbers[1]));
}

TEST_CASE("A file that is cut short, or in which a byte has changed, is refused") {
  const fs::path file = scratch_file("damaged.json");
  write_reference_results(lecture(), file);
  const std::string text = read(file);
  std::mt19937 random(1);
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  for (int k = 0; k < 300; ++k) {
    // Every third time in the first line, which no checksum protects.
    const std::size_t at = below(k % 3 == 0 ? text.find('\n') + 1 : text.size());
    std::string mutated = text;
    mutated[at] = static_cast<char>(mutated[at] ^ static_cast<char>(1 + below(255)));
    CAPTURE(at);
    for (const std::string& damaged : {mutated, text.substr(0, at)}) {
      write(file, damaged);
      check_unreadable(file);
    }
  }
}

TEST_CASE("Other files, folders and files that are missing are refused") {
  const fs::path file = scratch_file("other.json");
  write_reference_results(lecture(), file);
  const std::string text = read(file);
  const std::string second_line = text.substr(text.find('\n') + 1);
  for (const std::string& other : {std::string(), std::string("\n"), std::string("[]\n[]\n"), std::string("{}\n{}\n"),
                                   std::string(100000, '[') + "\n", "\xff\xfe\n" + second_line, text + " ", second_line,
                                   "{\"format\":1,\"exercises\":[]}\n" + second_line}) {
    write(file, other);
    check_unreadable(file);
  }
  write(file, text);
  replace_in(file, "\"format\":", "\"format\":9");
  check_unreadable(file);
  check_unreadable(scratch_file("missing.json"));
  fs::create_directories(scratch_file("folder.json") / "something");
  check_unreadable(scratch_file("folder.json"));
  check_refused({"folder.json"}, [] { write_reference_results(lecture(), scratch_file("folder.json")); });
}

TEST_CASE("What contradicts itself is not written") {
  const std::vector<std::pair<std::size_t, void (*)(Exercise&)>> changes = {
      {0, [](Exercise& e) { e.cases.clear(); }},
      {0, [](Exercise& e) { e.cases[2].name = e.cases[1].name; }},
      {0, [](Exercise& e) { e.cases[0].name.clear(); }},
      {0, [](Exercise& e) { e.arguments[1].name = "m"; }},
      {0, [](Exercise& e) { e.misconceptions[1].name = "no_two"; }},
      {0, [](Exercise& e) { e.cases[0].inputs.pop_back(); }},
      {0, [](Exercise& e) { e.cases[0].inputs[0] = number(infinity); }},
      {0, [](Exercise& e) { e.cases[0].expected.numbers[1] = not_a_number; }},
      {0, [](Exercise& e) { e.cases[0].expected.numbers.pop_back(); }},
      {0, [](Exercise& e) { e.cases[0].scale.resize(2, 1); }},
      {0, [](Exercise& e) { e.cases[0].scale = {0}; }},
      {0, [](Exercise& e) { e.cases[0].scale = {infinity}; }},
      {0, [](Exercise& e) { e.cases[0].tolerance = not_a_number; }},
      {0, [](Exercise& e) { std::swap(e.cases[9], e.cases[0]); }},
      {0, [](Exercise& e) { e.cases[9].deciding = true; }},
      {0, [](Exercise& e) { e.cases[9].base = 10; }},
      {0, [](Exercise& e) { e.cases[9].argument = 3; }},
      {0, [](Exercise& e) { e.result_units.clear(); }},
      {0, [](Exercise& e) { e.result_units.resize(2); }},
      {0, [](Exercise& e) { e.misconceptions[0].outputs.pop_back(); }},
      {0, [](Exercise& e) { e.misconceptions[0].outputs[3] = number(1); }},
      {0, [](Exercise& e) { e.misconceptions[0].sweep_outputs.pop_back(); }},
      {0, [](Exercise& e) { e.input_transforms[0].outputs.pop_back(); }},
      {0, [](Exercise& e) { e.terms[0].outputs.push_back(e.terms[0].outputs[0]); }},
      {0, [](Exercise& e) { e.routes[2].outputs[0] = number(1); }},
      {0, [](Exercise& e) { e.sweep.inputs.pop_back(); }},
      {0, [](Exercise& e) { e.sweep.components[0].row = 3; }},
      {0, [](Exercise& e) { e.sweep.components[0].col = -1; }},
      {0, [](Exercise& e) { e.limits[0].case_index = 9; }},
      {0, [](Exercise& e) { e.limits[0].reason.clear(); }},
      {0, [](Exercise& e) { e.measured[0].inputs.pop_back(); }},
      {0, [](Exercise& e) { e.measured[0].errors.pop_back(); }},
      {0, [](Exercise& e) { add_property(e, P::symmetric, "It is symmetric."); }},
      {1, [](Exercise& e) { e.properties[1].argument = 1; }},
      {1, [](Exercise& e) { e.properties[1].argument = -1; }},
      {1, [](Exercise& e) { e.arguments[0].kind = Kind::vector; }},
      {1, [](Exercise& e) { e.comparison = Comparison::eigenvectors; }},
      {2, [](Exercise& e) { e.comparison = Comparison::attitude_by_angles; }},
      {3, [](Exercise& e) { e.properties[0].weights.pop_back(); }},
      {3, [](Exercise& e) { e.properties[0].weights[0].pop_back(); }},
      {4, [](Exercise& e) { e.cases[0].scale.clear(); }},  // as many as there are numbers
  };
  const fs::path file = scratch_file("unsound.json");
  fs::remove(file);
  for (std::size_t k = 0; k < changes.size(); ++k) {
    CAPTURE(k);
    LectureReference results = lecture();
    Exercise& changed = results.exercises[changes[k].first];
    changes[k].second(changed);
    check_refused({"99_made_up", changed.name}, [&] { write_reference_results(results, file); });
  }
  CHECK_FALSE(fs::exists(file));
}

TEST_CASE("Each mistake of an author is told in a sentence of its own, and a sound exercise has none") {
  std::string text;
  for (const Mistake& mistake : mistakes) {
    CAPTURE(mistake.about);
    Exercise exercise = sound_momentum();
    mistake.make(exercise);
    const std::vector<std::string> found = unsound_parts(exercise);
    CHECK(found.size() == mistake.sentences);
    text += mistake.about + "\n" + joined(found) + "\n";
  }
  compare_with_golden_file("soundness.txt", text);
}

}  // namespace workbook::testing
