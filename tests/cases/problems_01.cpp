// Worked values of the problems of lecture 01, computed elsewhere in 34 digits by two routes each.
#include "tests/cases/problems.hpp"

#include <rigid/frame_derivatives.hpp>

namespace problems_01 {

const Vector3d zero = Vector3d::Zero(), omega(0.3, -0.2, 0.5);

TEST_CASE("composed_angular_acceleration") {
  const Vector3d rotation(0.2, 0.5, -0.3), alpha(0.05, 0.1, -0.04), spin(2, -1, 4), spin_rate(0.1, -0.3, 0.2);
  const Matrix3d E = Eigen::AngleAxisd(rotation.norm(), rotation.normalized()).toRotationMatrix();
  CHECK(agrees(composed_angular_acceleration(E, omega, alpha, spin, spin_rate),
               Vector3d(0.879010483569, 0.595535841966, -0.0654404658725), digits));
  CHECK(agrees(composed_angular_acceleration(E, omega, zero, spin, zero),
               Vector3d(0.756443697765, 0.851983032389, -0.113073005703), digits));
  CHECK(agrees(composed_angular_acceleration(Matrix3d::Identity(), {0, 0, 2}, zero, {30, 0, 0}, zero),
               Vector3d(0, 60, 0), digits));
}

TEST_CASE("rotation_vector") {
  const auto found = [](const Vector3d& v) {
    return rotation_vector(Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix());
  };
  const auto up_to_sign = [](const Vector3d& v) { return v[0] < 0 ? Vector3d(-v) : v; };
  CHECK(agrees(found({1.2, -0.7, 2.1}), Vector3d(1.2, -0.7, 2.1), digits));
  const Matrix3d half_turn{{-7 / 9.0, 4 / 9.0, 4 / 9.0}, {4 / 9.0, -1 / 9.0, 8 / 9.0}, {4 / 9.0, 8 / 9.0, -1 / 9.0}};
  CHECK(agrees(up_to_sign(rotation_vector(half_turn)), Vector3d(1.0471975512, 2.09439510239, 2.09439510239),
               digits * 10));
  CHECK(agrees(found((std::numbers::pi - 1e-8) / 3 * Vector3d(1, 2, 2)),
               Vector3d(1.04719754786, 2.09439509573, 2.09439509573), digits));
  CHECK(agrees(found({2e-9, -1e-9, 2e-9}), Vector3d(2e-9, -1e-9, 2e-9), digits));
  CHECK(agrees(rotation_vector(Matrix3d::Identity()), zero, digits, 1));
}

TEST_CASE("angular_velocity_from_three_points") {
  const Matrix3d r{{1, 0.3, -0.6}, {0.5, 1.8, 0.2}, {-0.2, 0.4, 1.5}};
  const auto found = [&](const Vector3d& v0, const Vector3d& w) {
    Matrix3d v;
    for (int i = 0; i < 3; ++i) v.col(i) = v0 + w.cross(r.col(i));
    return angular_velocity_from_three_points(r, v);
  };
  CHECK(agrees(found({1, -2, 0.5}, omega), omega, digits));
  CHECK(agrees(found({1, -2, 0.5}, 0.4 * (r.col(1) - r.col(0))), Vector3d(-0.28, 0.52, 0.24), digits));
  CHECK(agrees(found({3, 0, 0}, zero), zero, digits, 1));
  CHECK(agrees(found(zero, {0, 0, 2}), Vector3d(0, 0, 2), digits));
}

TEST_CASE("point_on_screw_axis") {
  const Vector3d r(1, 2, -1);
  CHECK(agrees(point_on_screw_axis(r, {0.4, -0.3, 0.6}, omega), Vector3d(1.55263157895, 1.73684210526, -0.236842105263),
               digits));
  CHECK(agrees(point_on_screw_axis(r, 3 * omega, omega), Vector3d(1.47368421053, 1.68421052632, -0.210526315789),
               digits));
  CHECK(agrees(point_on_screw_axis({7, 0.5, 0}, {2, 0, 0}, {0, 0, -4}), Vector3d(7, 0, 0), digits));
}

TEST_CASE("screw_of_displacement: points of the line go along it") {
  for (const double angle : {0.01, 1.1, std::numbers::pi, 4.0, 6.2}) {
    CAPTURE(angle);
    const Vector3d n = Vector3d(2, -1, 2) / 3, d(0.3, -0.7, 0.2);
    const Matrix3Xd screw = screw_of_displacement(angle * n, d);
    const Vector3d c = screw.col(0), on_the_line = c + 5 * n;
    CHECK(agrees(Vector3d(Eigen::AngleAxisd(angle, n) * on_the_line + d), Vector3d(on_the_line + screw.col(1)), 1e-13,
                 c.norm()));
    CHECK(agrees(c.dot(n), 0.0, 1e-14, c.norm()));
    CHECK(screw.col(1).cross(n).norm() < 1e-15);
  }
}

}  // namespace problems_01
