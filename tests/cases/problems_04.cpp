// Worked values of the problems of lecture 04, computed elsewhere in 34 digits by two routes each.
#include "tests/cases/problems.hpp"

#include <rigid/parallel_axis.hpp>

namespace problems_04 {

TEST_CASE("block_with_hole") {
  CHECK(agrees(block_with_hole(800, {0.4, 0.3, 0.2}, {0.05, -0.04, 0.02}, 0.07),
               Matrix3d{{0.203301979311, -0.00244518878573, 0.00122259439287},
                        {-0.00244518878573, 0.314201644358, -9.78075514292e-4},
                        {0.00122259439287, -9.78075514292e-4, 0.392734531086}},
               digits));
  CHECK(agrees(block_with_hole(800, {0.4, 0.3, 0.2}, {0, 0, 0}, 0.07),
               Matrix3d(Vector3d(0.205747168097, 0.317747168097, 0.397747168097).asDiagonal()), digits));
  CHECK(agrees(block_with_hole(800, {0.4, 0.3, 0.2}, {0.05, -0.04, 0.02}, 0),
               Matrix3d(Vector3d(0.208, 0.32, 0.4).asDiagonal()), digits));
  CHECK(agrees(block_with_hole(2700, {1, 1, 1}, {-0.2, 0.2, 0.2}, 0.3),
               Matrix3d{{411.46273887, -13.7721000584, -13.7721000584},
                        {-13.7721000584, 411.46273887, 13.7721000584},
                        {-13.7721000584, 13.7721000584, 411.46273887}},
               digits));
}

TEST_CASE("gravity_from_kater") {
  CHECK(agrees(gravity_from_kater(0.62, 1.7362, 0.2, 1.5539), 9.80978132108, digits));
  CHECK(agrees(gravity_from_kater(0.7, 2, 0.29396, 2), 9.80999199051, digits));
  CHECK(agrees(gravity_from_kater(0.05, 1.8495, 0.5, 1.5278), 9.80961801716, digits));
}

TEST_CASE("toppling_speed") {
  CHECK(agrees(toppling_speed(0.3, 0.5, 9.81), 1.21579755992, digits));
  CHECK(agrees(toppling_speed(0.2, 0.2, 9.81), 1.47212953178, digits));
  CHECK(agrees(toppling_speed(1, 0.1, 9.81), 34.576884888, digits));
  CHECK(agrees(toppling_speed(0.1, 2, 9.81), 0.181000792753, digits));
}

TEST_CASE("velocity_after_blow") {
  const Matrix3d I{{19.7, 0, 2.5}, {0, 16.6, 6.4}, {2.5, 6.4, 8.1}};
  const Vector3d struck(0.5, -0.3, 0.8), impulse(2, -1, 4);
  CHECK(agrees(velocity_after_blow(10, I, struck, impulse, {-0.7, 0.4, 0.2}),
               Vector3d(0.167805315844, -0.134647221263, 0.356613047981), digits));
  CHECK(agrees(velocity_after_blow(10, I, struck, impulse, struck),
               Vector3d(0.180238982856, -0.049242319641, 0.43138476585), digits));
  const Matrix3d bat = Vector3d(0.001, 0.045, 0.045).asDiagonal();
  CHECK(agrees(velocity_after_blow(0.9, bat, {0.125, 0, 0}, {0, 3, 0}, {-0.4, 0, 0}), Vector3d(0, 0, 0), digits, 3));
  CHECK(
      agrees(velocity_after_blow(0.9, bat, {0, 0, 0}, {0, 3, 0}, {-0.4, 0, 0}), Vector3d(0, 3.33333333333, 0), digits));
}

}  // namespace problems_04
