// Comparing an answer with the expected one: tolerances at their edge, and the freedom that an exercise leaves.
#include "checker/judging/comparison.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace workbook::testing {
namespace {

ExerciseReference one_number(double expected, double scale, double tolerance) {
  ExerciseReference exercise = given_results(Kind::number, {number(expected)});
  exercise.cases[0].scale = {scale};
  exercise.cases[0].tolerance = tolerance;
  return exercise;
}

ExerciseReference quaternion() {
  ExerciseReference exercise = given_results(Kind::vector, {vector({0.5, -0.5, 0.5, 0.5})});
  exercise.comparison = Comparison::up_to_sign;
  return exercise;
}

Eigen::Matrix3d some_axes() {
  return (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

ExerciseReference axes_of(const Eigen::Vector3d& moments) {
  const Eigen::Matrix3d V = some_axes();
  ExerciseReference exercise = given_results(Kind::matrix3, {to_value(V)});
  exercise.arguments = {{"I", Kind::matrix3, units::moment_of_inertia}};
  exercise.cases[0].inputs = {to_value(V * moments.asDiagonal() * V.transpose())};
  exercise.comparison = Comparison::eigenvectors;
  return exercise;
}

ExerciseReference angles(double phi, double theta, double psi) {
  ExerciseReference exercise = given_results(Kind::vector3, {vector({phi, theta, psi})});
  exercise.comparison = Comparison::attitude_by_angles;
  return exercise;
}

}  // namespace

TEST_CASE("A difference of just the tolerance passes, one beyond it does not") {
  // Powers of two, so that the edge is hit exactly.
  const ExerciseReference exercise = one_number(8, 4, 0.125);
  CHECK(passes(exercise, 0, number(8)));
  CHECK(passes(exercise, 0, number(8.5)));
  CHECK(passes(exercise, 0, number(7.5)));
  CHECK_FALSE(passes(exercise, 0, number(std::nextafter(8.5, 9))));
  CHECK_FALSE(passes(exercise, 0, number(std::nextafter(7.5, 7))));
}

TEST_CASE("Neither NaN nor infinity passes") {
  const ExerciseReference exercise = one_number(8, 4, 0.125);
  for (double odd : {not_a_number, infinity, -infinity}) CHECK_FALSE(passes(exercise, 0, number(odd)));
}

TEST_CASE("A value of another shape, or with too few numbers, does not pass") {
  const ExerciseReference exercise = given_results(Kind::vector, {vector({1, 2, 3})});
  CHECK(passes(exercise, 0, vector({1, 2, 3})));
  CHECK_FALSE(passes(exercise, 0, vector({1, 2})));
  CHECK_FALSE(passes(exercise, 0, vector({1, 2, 3, 0})));
  CHECK_FALSE(passes(exercise, 0, {1, 3, {1, 2, 3}}));
  CHECK_FALSE(passes(exercise, 0, {3, 1, {1, 2}}));
}

TEST_CASE("An empty list is right where an empty list is expected") {
  const ExerciseReference exercise = given_results(Kind::vector, {vector({})});
  CHECK(passes(exercise, 0, vector({})));
  CHECK_FALSE(passes(exercise, 0, vector({0})));
}

TEST_CASE("With a scale for each number, each is held to its own") {
  ExerciseReference exercise = given_results(Kind::vector2, {vector({1000, 1})});
  exercise.cases[0].scale = {1000, 1};
  exercise.cases[0].tolerance = 1e-3;
  CHECK(passes(exercise, 0, vector({1000.5, 1})));
  CHECK_FALSE(passes(exercise, 0, vector({1000, 1.5})));
}

TEST_CASE("A quaternion and its negative are both right, a mixture of the two is not") {
  const ExerciseReference exercise = quaternion();
  CHECK(passes(exercise, 0, vector({0.5, -0.5, 0.5, 0.5})));
  CHECK(passes(exercise, 0, vector({-0.5, 0.5, -0.5, -0.5})));
  CHECK_FALSE(passes(exercise, 0, vector({-0.5, -0.5, 0.5, 0.5})));
  CHECK(is_same_answer(exercise, 0, vector({1, 2, 3, 4}), vector({-1, -2, -3, -4})));
  CHECK_FALSE(is_same_answer(exercise, 0, vector({1, 2, 3, 4}), vector({-1, -2, -3, 4})));
}

TEST_CASE("Eigenvectors pass with any signs that keep them right-handed, and not as rows") {
  const ExerciseReference exercise = axes_of({1, 2, 4});
  Eigen::Matrix3d V = some_axes();
  CHECK(passes(exercise, 0, to_value(V)));
  V.col(0) = -V.col(0);
  CHECK_FALSE(passes(exercise, 0, to_value(V)));  // left-handed
  V.col(2) = -V.col(2);
  CHECK(passes(exercise, 0, to_value(V)));
  CHECK_FALSE(passes(exercise, 0, to_value(V.transpose())));
  CHECK_FALSE(passes(exercise, 0, to_value(2 * V)));
  V.col(0).swap(V.col(1));
  V.col(2) = -V.col(2);
  CHECK_FALSE(passes(exercise, 0, to_value(V)));  // in another order
}

TEST_CASE("For equal moments any orthonormal choice of axes passes") {
  const ExerciseReference exercise = axes_of({1, 1, 4});
  const Eigen::Matrix3d turned = some_axes() * Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  CHECK(passes(exercise, 0, to_value(turned)));
  CHECK_FALSE(passes(axes_of({1, 1.5, 4}), 0, to_value(turned)));
}

TEST_CASE("Eigenvectors are one wrong answer whatever their signs, as columns or as rows") {
  const ExerciseReference exercise = axes_of({1, 2, 4});
  const Eigen::Matrix3d V = some_axes();
  const Eigen::Matrix3d signs = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  CHECK(is_same_answer(exercise, 0, to_value(V * signs), to_value(V)));
  CHECK(is_same_answer(exercise, 0, to_value(signs * V.transpose()), to_value(V.transpose())));
  CHECK_FALSE(is_same_answer(exercise, 0, to_value(V.transpose()), to_value(V)));
}

TEST_CASE("Angles pass if they give the attitude") {
  const double pi = std::numbers::pi;
  const ExerciseReference exercise = angles(0.3, 0.7, 1.1);
  CHECK(passes(exercise, 0, vector({0.3, 0.7, 1.1})));
  CHECK(passes(exercise, 0, vector({0.3 + 2 * pi, 0.7, 1.1 - 2 * pi})));
  CHECK(passes(exercise, 0, vector({0.3 + pi, -0.7, 1.1 - pi})));
  CHECK_FALSE(passes(exercise, 0, vector({1.1, 0.7, 0.3})));
  CHECK_FALSE(passes(exercise, 0, vector({0.3, -0.7, 1.1})));
}

TEST_CASE("Without a tilt only the sum of the two other angles counts, and with θ = π only their difference") {
  CHECK(passes(angles(0.3, 0, 1.1), 0, vector({1.4, 0, 0})));
  CHECK_FALSE(passes(angles(0.3, 0, 1.1), 0, vector({0.8, 0, 0})));
  CHECK(passes(angles(0.3, std::numbers::pi, 1.1), 0, vector({0, std::numbers::pi, 0.8})));
}

TEST_CASE("The attitude of angles is R_ψ R_θ R_φ with passive rotations about z, y, z") {
  // R (0.3, 0.7, 1.1), entry by entry from the general formula.
  const Value identity = vector({0, 0, 0});
  const std::vector<Deviation> measured = deviations(angles(0.3, 0.7, 1.1), 0, identity);
  const Eigen::Matrix3d R = Eigen::Matrix3d::Identity() - Eigen::Matrix3d(as_matrix(measured.at(0).difference));
  const Eigen::Matrix3d expected = (Eigen::Matrix3d() << 0.068064579, 0.95392757, -0.29221464,  //
                                    -0.78523568, 0.23190061, 0.57413154,                        //
                                    0.61544466, 0.19037934, 0.76484219)
                                       .finished();
  CHECK((R - expected).cwiseAbs().maxCoeff() <= 1e-8);
}

TEST_CASE("A conserved sum is held to its own size, more strictly than the entries") {
  ExerciseReference exercise = given_results(Kind::points, {three_rows({{1, 0}, {0, 1}, {2, 2}})});
  exercise.properties = {{PropertyKind::constant_weighted_square, "The sum stays the same.", "", -1, {{1, 1, 0}}}};
  exercise.cases[0].tolerance = 1e-3;
  CHECK(passes(exercise, 0, three_rows({{1, 0}, {0, 1}, {2, 2.001}})));   // carries no weight
  CHECK(passes(exercise, 0, three_rows({{1, 0}, {0, 1.0004}, {2, 2}})));  // 0.0008 of 1
  CHECK_FALSE(
      passes(exercise, 0, three_rows({{1, 0}, {0, 1.0009}, {2, 2}})));  // within 0.002 for an entry, but 0.0018 of 1
  CHECK_FALSE(
      passes(exercise, 0, three_rows({{1.0009, 0}, {0, 1.0009}, {2, 2}})));  // constant, but not the right constant
}

TEST_CASE("Two wrong answers are one if they agree within the tolerance, and not finite in the same places") {
  const ExerciseReference exercise = given_results(Kind::vector3, {vector({1, 1, 1})});
  CHECK(is_same_answer(exercise, 0, vector({5, not_a_number, 1}), vector({5, infinity, 1})));
  CHECK_FALSE(is_same_answer(exercise, 0, vector({5, not_a_number, 1}), vector({5, 1, not_a_number})));
  CHECK_FALSE(is_same_answer(exercise, 0, vector({5, not_a_number, 1}), vector({5, 2, 1})));
  CHECK(is_same_answer(exercise, 0, vector({5, 2, 1}),
                       vector({5 + 4e-9, 2, 1})));  // relative to the larger of size and entry
  CHECK_FALSE(is_same_answer(exercise, 0, vector({5, 2, 1}), vector({5 + 6e-9, 2, 1})));
  CHECK_FALSE(is_same_answer(exercise, 0, vector({5, 2, 1}), vector({5, 2})));
}

}  // namespace workbook::testing
