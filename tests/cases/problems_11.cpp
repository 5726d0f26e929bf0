// Values of the problems of lecture 11, from computations in 30 digits by other ways than those of the solutions.
#include "tests/cases/problems.hpp"

#include <rigid/measured.hpp>

namespace problems_11 {

TEST_CASE("moment_ratios: coefficients made from moments") {
  CHECK(agrees(moment_ratios(-0.923076923076923077, 0.315789473684210526), Vector2d(0.538461538462, 1.46153846154),
               1e-11));
  CHECK(agrees(moment_ratios(0.590909090909090909, -0.4375), Vector2d(1.31818181818, 0.727272727273), 1e-11));
}

TEST_CASE("moment_from_pendulum: derivatives by differences in 30 digits") {
  CHECK(agrees(moment_from_pendulum(0.45728, 9.809, 0.413, 1.436, 0.005, 0.039),
               Vector2d(0.0187644973384, 0.00530458581331), 1e-11));
  CHECK(
      agrees(moment_from_pendulum(2, 9.81, 0.3, 1.5, 0.002, 0.01), Vector2d(0.155461773892, 0.00447581417304), 1e-11));
  CHECK(agrees(moment_from_pendulum(1.3, 9.81, 0.6, 1.6, 0.01, 0.005), Vector2d(0.0281852371164, 0.00795925162334),
               1e-11));
}

TEST_CASE("damped_rotation: L with the torque, by Taylor series") {
  CHECK(agrees(damped_rotation({1, 2, 3}, {0.1, 1, 0.1}, 0.05, 8),
               Vector3d(-0.663913071204, 0.114200208596, 0.387198116988), 1e-10));
  CHECK(agrees(damped_rotation({1, 0.0802, 1.0747}, {16.2, -7.6, -4.7}, 0.22, 0.8),
               Vector3d(0.390720073236, -14.6061834066, -13.2001525117), 1e-10));
  CHECK(agrees(damped_rotation({2.7, 1.2, 2}, {-0.4, 0.5, 0.3}, 0.3, 4),
               Vector3d(-0.131461671349, 0.167712871477, -0.0340571791086), 1e-10));
}

}  // namespace problems_11
