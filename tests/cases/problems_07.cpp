// The problems of lecture 07 at inputs whose answers were computed elsewhere, in 34 digits.
#include "tests/cases/problems.hpp"

#include <rigid/euler_angles.hpp>

namespace problems_07 {

namespace {

constexpr double last_digit = 2e-12;  // the values below have twelve digits
const Vector3d lecture(0.3, 0.7, 1.1), other_quadrants(2.8, -0.4, 5.1);

VectorXd quaternion(double w, double x, double y, double z) { return VectorXd{{w, x, y, z}}; }

/// From inertial to body components.
Matrix3d rolled_pitched_yawed(const Vector3d& q) {
  return (Eigen::AngleAxisd(q[0], Vector3d::UnitZ()) * Eigen::AngleAxisd(q[1], Vector3d::UnitY()) *
          Eigen::AngleAxisd(q[2], Vector3d::UnitX()))
      .toRotationMatrix()
      .transpose();
}

}  // namespace

TEST_CASE("yaw, pitch and roll") {
  CHECK(agrees(yaw_pitch_roll(lecture), Vector3d(1.4995651088, 0.296541740156, 0.643919284111), last_digit, 10));
  CHECK(agrees(yaw_pitch_roll(other_quadrants), Vector3d(1.58888316486, -0.147728207437, 0.373095097064), last_digit,
               10));
  CHECK(agrees(yaw_pitch_roll({0.3, 0, 1.1}), Vector3d(1.4, 0, 0), 1e-15));
  // With the nose straight down or up only one combination of yaw and roll counts.
  const Vector3d vertical = yaw_pitch_roll({0.3, pi / 2, pi});
  CHECK(agrees(vertical[1], -pi / 2, 1e-15));
  CHECK(agrees(rolled_pitched_yawed(vertical), rolled_pitched_yawed({-2.84159265359, -pi / 2, 0}), last_digit, 10));
}

TEST_CASE("the quaternion of an attitude, whose sign is free") {
  const auto with_sign_of = [](const VectorXd& other, const VectorXd& q) -> VectorXd {
    return q.dot(other) < 0 ? VectorXd(-q) : q;
  };
  const auto check = [&](const Vector3d& angles, const VectorXd& expected) {
    CHECK(agrees(with_sign_of(expected, attitude_quaternion(angles)), expected, last_digit, 1));
  };
  check(lecture, quaternion(0.71847188037, 0.133530695761, 0.315829795376, 0.605160516525));
  check({0, pi, 0}, quaternion(0, 0, 1, 0));
  check(other_quadrants, quaternion(-0.676884056688, -0.181338201185, -0.0811539265186, -0.708772509909));
  check({0.3, 0, 1.1}, quaternion(0.764842187284, 0, 0, 0.644217687238));
}

TEST_CASE("the angle between two attitudes") {
  CHECK(agrees(angle_between_attitudes(lecture, {-0.4, 1.2, 2}), 0.872620395816, last_digit));
  CHECK(agrees(angle_between_attitudes(lecture, lecture + Vector3d(1e-8, 0, 0)), 1e-8, 1e-15, 1));
  CHECK(agrees(angle_between_attitudes(lecture, {0.3 + pi, -0.7, 1.1 + pi}), 0.0, 1e-15, 1));
  CHECK(agrees(angle_between_attitudes({0, 0, 0}, {0, pi, 0.4}), pi, 1e-15));
  CHECK(agrees(angle_between_attitudes({0, 0, 0}, {3, 0, 3}), 2 * pi - 6, 1e-14));
}

TEST_CASE("the shortest rotation from one direction to another") {
  CHECK(agrees(shortest_rotation({1, 2, -1}, {0.4, -0.3, 0.6}),
               Matrix3d{{-0.0377974848772, 0.152346750934, -0.987604079385},
                        {-0.997611670743, 0.0514249233249, 0.0461132481876},
                        {0.0578126675941, 0.986988320468, 0.150039163969}},
               last_digit));
  CHECK(agrees(shortest_rotation({1, 0, 0}, {-1, 0.01, 0.02}),
               Matrix3d{{-0.999750093711, -0.00999750093711, -0.0199950018742},
                        {0.00999750093711, 0.600049981258, -0.799900037484},
                        {0.0199950018742, -0.799900037484, -0.599800074969}},
               last_digit));
  CHECK(agrees(shortest_rotation({0, 0, 2}, {0, 0, 5}), Matrix3d(Matrix3d::Identity()), 1e-15));
  CHECK(agrees(shortest_rotation({1, 0, 0}, {0, 3, 0}), Matrix3d{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, 1e-15));
}

TEST_CASE("to_zxz: three turns about z, x and z reach the attitude of three about z, y and z") {
  const auto turned = [](const Vector3d& q, const Vector3d& middle) -> Matrix3d {
    return (Eigen::AngleAxisd(q[0], Vector3d::UnitZ()) * Eigen::AngleAxisd(q[1], middle) *
            Eigen::AngleAxisd(q[2], Vector3d::UnitZ()))
        .toRotationMatrix();
  };
  for (const Vector3d& q : {lecture, other_quadrants, Vector3d(7.5, 4, -8.2), Vector3d(0.4, 0, 0.9),
                            Vector3d(0.4, pi, 1.9), Vector3d(0.4, 1e-5, 0.9)}) {
    CAPTURE(q.transpose());
    const Vector3d found = to_zxz(q);
    CHECK(agrees(turned(found, Vector3d::UnitX()), turned(q, Vector3d::UnitY()), 1e-14, 1));
    CHECK((found[1] >= 0 && found[1] <= pi && std::abs(found[0]) <= pi && std::abs(found[2]) <= pi));
  }
  CHECK(to_zxz({0.4, pi, 1.9})[2] == 0);
}

}  // namespace problems_07
