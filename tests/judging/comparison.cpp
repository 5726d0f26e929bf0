// Comparing an answer with the expected one: tolerances at their edge, and the freedom that an exercise leaves.
#include "checker/judging/comparison.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace workbook::testing {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Values = std::vector<Value>;

constexpr double pi = std::numbers::pi;

void check_passing(const Exercise& exercise, const Values& right, const Values& wrong) {
  for (const Value& value : right) CHECK(passes(exercise, 0, value));
  for (const Value& value : wrong) CHECK_FALSE(passes(exercise, 0, value));
}

Exercise held_to(Kind kind, const Value& expected, std::vector<double> scale, double tolerance) {
  Exercise exercise = given_results(kind, {expected});
  exercise.cases[0].scale = std::move(scale);
  exercise.cases[0].tolerance = tolerance;
  return exercise;
}

Matrix3d some_axes() {
  return (AngleAxisd(0.3, Vector3d::UnitX()) * AngleAxisd(0.7, Vector3d::UnitZ())).toRotationMatrix();
}

Exercise axes_of(const Vector3d& moments) {
  const Matrix3d V = some_axes();
  return eigenvectors(to_value(V * moments.asDiagonal() * V.transpose()), to_value(V));
}

Exercise angles(double phi, double theta, double psi) {
  return given_results(Kind::vector3, {vector({phi, theta, psi})}, Comparison::attitude_by_angles);
}

Exercise aircraft(double yaw, double pitch, double roll) {
  return given_results(Kind::vector3, {vector({yaw, pitch, roll})}, Comparison::attitude_by_yaw_pitch_roll);
}

}  // namespace

TEST_CASE("A difference of just the tolerance passes, one beyond it does not, nor does what is not finite") {
  // Powers of two, so that the edge is hit exactly.
  check_passing(held_to(Kind::number, number(8), {4}, 0.125), {number(8), number(8.5), number(7.5)},
                {number(std::nextafter(8.5, 9)), number(std::nextafter(7.5, 7)), number(not_a_number), number(infinity),
                 number(-infinity)});
  // With a scale for each number, each is held to its own.
  check_passing(held_to(Kind::vector2, vector({1000, 1}), {1000, 1}, 1e-3), {vector({1000.5, 1})},
                {vector({1000, 1.5})});
}

TEST_CASE("A value of another shape, or with too few numbers, does not pass") {
  check_passing(given_results(Kind::vector, {vector({1, 2, 3})}), {vector({1, 2, 3})},
                {vector({1, 2}), vector({1, 2, 3, 0}), {1, 3, {1, 2, 3}}, {3, 1, {1, 2}}});
  check_passing(given_results(Kind::vector, {vector({})}), {vector({})}, {vector({0})});
}

TEST_CASE("A quaternion and its negative are both right, a mixture of the two is not") {
  const auto quaternion = given_results(Kind::vector, {vector({0.5, -0.5, 0.5, 0.5})}, Comparison::up_to_sign);
  check_passing(quaternion, {vector({0.5, -0.5, 0.5, 0.5}), vector({-0.5, 0.5, -0.5, -0.5})},
                {vector({-0.5, -0.5, 0.5, 0.5})});
  CHECK(is_same_answer(quaternion, 0, vector({1, 2, 3, 4}), vector({-1, -2, -3, -4})));
  CHECK_FALSE(is_same_answer(quaternion, 0, vector({1, 2, 3, 4}), vector({-1, -2, -3, 4})));
}

TEST_CASE("Eigenvectors pass with any signs that keep them right-handed, in their order, and not as rows") {
  const Matrix3d V = some_axes();
  const auto with_signs = [&V](double a, double b, double c) { return to_value(V * Vector3d(a, b, c).asDiagonal()); };
  const Matrix3d exchanged = (Matrix3d() << V.col(1), V.col(0), -V.col(2)).finished();
  check_passing(axes_of({1, 2, 4}), {with_signs(1, 1, 1), with_signs(-1, 1, -1), with_signs(-1, -1, 1)},
                {with_signs(-1, 1, 1), with_signs(2, 1, 1), to_value(V.transpose()), to_value(exchanged)});
  // For equal moments any orthonormal choice of axes passes.
  const Matrix3d turned = V * AngleAxisd(1.1, Vector3d::UnitZ()).toRotationMatrix();
  check_passing(axes_of({1, 1, 4}), {to_value(turned), to_value(exchanged)}, {});
  check_passing(axes_of({1, 1.5, 4}), {}, {to_value(turned)});
}

TEST_CASE("Angles pass if they give the attitude, with θ in [0, π]") {
  check_passing(angles(0.3, 0.7, 1.1), {vector({0.3, 0.7, 1.1}), vector({0.3 + 2 * pi, 0.7, 1.1 - 4 * pi})},
                {vector({1.1, 0.7, 0.3}), vector({0.3, -0.7, 1.1}), vector({0.3 + pi, -0.7, 1.1 + pi}),
                 vector({0.3, 0.7 + 2 * pi, 1.1})});
  // Without a tilt only the sum of the two other angles counts, and with θ = π only their difference.
  check_passing(angles(0.3, 0, 1.1), {vector({1.4, 0, 0})}, {vector({0.8, 0, 0})});
  check_passing(angles(0.3, pi, 1.1), {vector({0, pi, 0.8})}, {});
}

TEST_CASE("The attitude of angles is that of passive rotations about z, y, z") {
  const auto active =
      AngleAxisd(0.3, Vector3d::UnitZ()) * AngleAxisd(0.7, Vector3d::UnitY()) * AngleAxisd(1.1, Vector3d::UnitZ());
  const Matrix3d passive = active.toRotationMatrix().transpose();
  const Value difference = deviations(angles(0.3, 0.7, 1.1), 0, vector({0, 0, 0})).at(0).difference;
  CHECK(as_matrix(difference).isApprox(Matrix3d::Identity() - passive, 1e-12));
}

TEST_CASE("A conserved sum is held to its own size, more strictly than the entries") {
  // An entry without weight, and 0.0008 of 1; then 0.0018 of 1, and another constant.
  check_passing(conserved(), {three_rows({{1, 0}, {0, 1}, {2, 2.001}}), three_rows({{1, 0}, {0, 1.0004}, {2, 2}})},
                {three_rows({{1, 0}, {0, 1.0009}, {2, 2}}), three_rows({{1.0009, 0}, {0, 1.0009}, {2, 2}})});
}

TEST_CASE("Yaw, pitch and roll are compared through their matrix, with the pitch in its range") {
  check_passing(aircraft(0.3, 0.7, 1.1), {vector({0.3 + 2 * pi, 0.7, 1.1 - 2 * pi})},
                {vector({0.3 + pi, pi - 0.7, 1.1 + pi}), vector({0.3, -0.7, 1.1}), vector({1.1, 0.7, 0.3})});
  check_passing(aircraft(0.3, pi / 2, 0), {vector({1.3, pi / 2, 1})}, {vector({1.3, pi / 2, -1})});
}

TEST_CASE("Two wrong answers are one if they agree within the tolerance, and not finite in the same places") {
  const Exercise exercise = given_results(Kind::vector3, {vector({1, 1, 1})});
  const auto is_same = [&](const Value& one, const Value& other) { return is_same_answer(exercise, 0, one, other); };
  CHECK(is_same(vector({5, not_a_number, 1}), vector({5, infinity, 1})));
  CHECK_FALSE(is_same(vector({5, not_a_number, 1}), vector({5, 1, not_a_number})));
  CHECK_FALSE(is_same(vector({5, not_a_number, 1}), vector({5, 2, 1})));
  CHECK(is_same(vector({5, 2, 1}), vector({5 + 4e-9, 2, 1})));  // relative to the larger of size and entry
  CHECK_FALSE(is_same(vector({5, 2, 1}), vector({5 + 6e-9, 2, 1})));
  CHECK_FALSE(is_same(vector({5, 2, 1}), vector({5, 2})));
}

}  // namespace workbook::testing
