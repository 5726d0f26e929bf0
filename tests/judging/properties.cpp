// Properties of right results: said of a student's result only if it lacks them, and right ones have them.
#include "checker/judging/properties.hpp"
#include "checker/judging/judge.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>

namespace workbook::testing {
namespace {

struct Broken {
  PropertyKind property;
  Kind kind;
  Value expected;
  Value actual;
  std::string detail;
};

Value diagonal(double a, double b, double c) { return three_rows({{a, 0, 0}, {0, b, 0}, {0, 0, c}}); }

std::vector<Broken> broken_properties() {
  const Value symmetric = three_rows({{2, 1, 0}, {1, 2, 0}, {0, 0, 2}});
  const Value turned = three_rows({{0, -1, 0}, {1, 0, 0}, {0, 0, 1}});
  return {
      {PropertyKind::symmetric, Kind::matrix3, symmetric, three_rows({{2, 1, 0}, {-1.5, 2, 0}, {0, 0, 2}}),
       "entry (1,2) is 1, entry (2,1) is -1.5"},
      {PropertyKind::symmetric, Kind::matrix3, symmetric, three_rows({{2, 1, 0}, {1 + 1e-7, 2, 0}, {0, 0, 3}}),
       "entry (1,2) is 1, entry (2,1) is 1.0000001"},
      {PropertyKind::antisymmetric, Kind::matrix3, three_rows({{0, 1, 2}, {-1, 0, 3}, {-2, -3, 0}}),
       three_rows({{0, 1, 2}, {-1, 0, 3}, {-2, 5, 0}}), "entry (2,3) is 3, entry (3,2) is 5"},
      {PropertyKind::antisymmetric, Kind::matrix3, three_rows({{0, 1, 2}, {-1, 0, 3}, {-2, -3, 0}}),
       three_rows({{0, 1, 2}, {-1, 0, 3}, {-2, -3, 4}}), "entry (3,3) is 4"},
      {PropertyKind::positive_semidefinite, Kind::matrix3, diagonal(1, 2, 0), diagonal(1, 2, -0.5),
       "its smallest eigenvalue is -0.5"},
      {PropertyKind::rotation_matrix, Kind::matrix3, turned, three_rows({{0, -1, 0}, {2, 0, 0}, {0, 0, 1}}),
       "column 1 has the length 2"},
      {PropertyKind::rotation_matrix, Kind::matrix3, turned, three_rows({{1, 0.5, 0}, {0, 0.875, 0}, {0, 0, 1}}),
       "columns 1 and 2 have the dot product 0.5"},
      {PropertyKind::rotation_matrix, Kind::matrix3, turned, three_rows({{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}),
       "its determinant is -1"},
      {PropertyKind::unit_norm, Kind::vector3, vector({0, 0.6, 0.8}), vector({0, 3, 4}), "its length is 5"},
      {PropertyKind::unit_norm, Kind::vector3, vector({0, 0.6, 0.8}), vector({0, 0.6, 0.80000005}),
       "its length is 1.00000004"},
      {PropertyKind::ascending, Kind::vector3, vector({1, 2, 2}), vector({2, 3, 1}),
       "component 2 is 3, component 3 is 1"},
      {PropertyKind::nonnegative, Kind::number, number(2), number(-3), "the result is -3"},
      {PropertyKind::nonnegative, Kind::vector2, vector({0, 2}), vector({1, -3}), "component 2 is -3"},
  };
}

ExerciseReference with_property(const Broken& broken) {
  // A second case keeps the answer from being a multiple of the right one.
  ExerciseReference exercise = given_results(broken.kind, {broken.expected, broken.expected});
  add_property(exercise, broken.property, "right results are so: always.");
  return exercise;
}

}  // namespace

TEST_CASE("A property that the student's result lacks is told with the entries that show it") {
  for (const Broken& broken : broken_properties()) {
    CAPTURE(broken.detail);
    const ExerciseReference exercise = with_property(broken);
    const Judgement judgement = judge(exercise, observed({broken.expected, broken.actual}));
    CHECK(judgement.verdict == Verdict::wrong_value);
    REQUIRE(judgement.diagnoses.size() == 1);
    CHECK(judgement.diagnoses[0].kind == DiagnosisKind::property);
    CHECK(judgement.diagnoses[0].name == to_string(broken.property));
    CHECK(judgement.diagnoses[0].notes == "made_up_anchor");
    CHECK(judgement.diagnoses[0].message ==
          std::string("Right results are so: always; with yours, ") + broken.detail + " (case “number 1”).");
  }
}

TEST_CASE("A wrong result that has the property is not accused of lacking it") {
  for (const Broken& broken : broken_properties()) {
    CAPTURE(broken.detail);
    const ExerciseReference exercise = with_property(broken);
    CHECK(diagnose_properties(exercise, all_answers({broken.expected, broken.expected})).empty());
    CHECK(violation(exercise, exercise.properties[0], 0, broken.expected).size <= 1e-15);
  }
}

TEST_CASE("A property that not even the expected results have is never told") {
  for (const Broken& broken : broken_properties()) {
    ExerciseReference exercise = with_property(broken);
    exercise.cases[0].expected = broken.actual;
    CHECK(diagnose_properties(exercise, all_answers({broken.actual, broken.actual})).empty());
  }
}

TEST_CASE("Rounding errors break no property, nor do values that are not finite or missing") {
  ExerciseReference exercise = given_results(Kind::matrix3, {diagonal(1, 2, 3)});
  add_property(exercise, PropertyKind::symmetric, "It is symmetric.");
  const Value nearly = three_rows({{1, 1e-9, 0}, {-1e-9, 2, 0}, {0, 0, 4}});
  CHECK(diagnose_properties(exercise, all_answers({nearly})).empty());
  CHECK(diagnose_properties(exercise, all_answers({diagonal(not_a_number, 1, 1)})).empty());
  CHECK(diagnose_properties(exercise, Answers(1)).empty());
}

TEST_CASE("A result that must be perpendicular to an argument is tested against that argument") {
  ExerciseReference exercise = given_results(Kind::vector3, {vector({0, 2, 0}), vector({0, 0, 3})});
  exercise.arguments = {{"omega", Kind::vector3, units::radian_per_second}};
  exercise.cases[0].inputs = {vector({4, 0, 0})};
  exercise.cases[1].inputs = {vector({0, 0, 0})};  // everything is perpendicular to zero
  exercise.properties = {{PropertyKind::orthogonal_to_argument, "ω × r is perpendicular to ω.", "", 0, {}}};
  CHECK(diagnose_properties(exercise, all_answers({vector({0, 1, 5}), vector({1, 2, 3})})).empty());
  const auto diagnoses = diagnose_properties(exercise, all_answers({vector({0.5, 2, 0}), vector({1, 2, 3})}));
  REQUIRE(diagnoses.size() == 1);
  CHECK(diagnoses[0].message ==
        "ω × r is perpendicular to ω; with yours, its dot product with omega is 2 (case “number 0”).");
}

TEST_CASE("A sum that must not drift is told with the column where it drifts most") {
  ExerciseReference exercise = given_results(Kind::points, {three_rows({{1, 0}, {0, 1}, {0, 0}})});
  exercise.properties = {
      {PropertyKind::constant_weighted_square, "The energy ½ Σ v² stays the same.", "energy", -1, {{0.5, 0.5, 0.5}}}};
  const auto diagnoses = diagnose_properties(exercise, all_answers({three_rows({{1, 0}, {0, 2}, {0, 0}})}));
  REQUIRE(diagnoses.size() == 1);
  CHECK(diagnoses[0].message ==
        "The energy ½ Σ v² stays the same; with yours, in column 2 it is 2 instead of 0.5 (case “number 0”).");
}

TEST_CASE("A drift alone is a wrong value, though every entry is within its tolerance") {
  ExerciseReference exercise = given_results(Kind::points, {three_rows({{1, 0}, {0, 1}, {0, 0}})});
  exercise.cases[0].tolerance = 1e-3;
  exercise.cases[0].scale = {100};
  exercise.properties = {
      {PropertyKind::constant_weighted_square, "The energy stays the same.", "energy", -1, {{1, 1, 1}}}};
  const Judgement judgement = judge(exercise, observed({three_rows({{1, 0}, {0, 1.05}, {0, 0}})}));
  CHECK(judgement.verdict == Verdict::wrong_value);
  REQUIRE(judgement.diagnoses.size() == 1);
  CHECK(judgement.diagnoses[0].kind == DiagnosisKind::property);
}

}  // namespace workbook::testing
