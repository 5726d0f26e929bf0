// Values of the problems of lecture 06, from computations in 34 digits by two ways that share no formula.
#include "tests/cases/problems.hpp"

#include <rigid/free_tops.hpp>

namespace problems_06 {

TEST_CASE("largest_rates: two invariants, and the motion integrated") {
  const Vector3d I(1.2, 2, 2.7);
  CHECK(agrees(largest_rates(I, {0.5, 0.6, 0.6}), Vector3d(0.728010988928, 0.825486869325, 0.708676387516), 1e-11));
  CHECK(agrees(largest_rates(I, {0.9, -0.6, 0.3}), Vector3d(1.04403065089, 0.76668931126, 0.481894409827), 1e-11));
  CHECK(agrees(largest_rates({1.1, 2.3, 3.1}, {0, 0, 0.7}), Vector3d(0, 0, 0.7), 1e-14));
  CHECK(agrees(largest_rates({1, 1, 1.8}, {0.3, -0.4, 2}), Vector3d(0.5, 0.5, 2), 1e-14));
}

TEST_CASE("flat_spin: the least energy, and an inner friction integrated") {
  CHECK(agrees(flat_spin({2.7, 1.2, 2}, {0.3, 5, -0.4}), Vector2d(8.37481481481, 2.26187159232), 1e-11));
  CHECK(agrees(flat_spin({0.03, 14, 14}, {78.5, 0, 0.01}), Vector2d(92.2356776786, 0.168511263476), 1e-11));
  CHECK(agrees(flat_spin({1, 1, 1.8}, {0.4, 0, 2}), Vector2d(0.0355555555556, 2.01230780847), 1e-11));
  CHECK(agrees(flat_spin({2, 2, 2}, {1, 2, 3}), Vector2d(0, 3.74165738677), 1e-11));
}

TEST_CASE("separatrix: hyperbolic functions, and the motion integrated") {
  const Vector3d I(1.2, 1.7, 2.6);
  CHECK(agrees(separatrix(I, 1.5, 0.8), Vector3d(1.29467962766, 0.639899824524, 0.655586513345), 1e-11));
  CHECK(agrees(separatrix(I, 1.5, -3), Vector3d(0.501876725547, -1.40478667791, 0.254135158692), 1e-11));
  CHECK(agrees(separatrix(I, 1.5, 0), Vector3d(1.43147027313, 0, 0.724853149205), 1e-11));
  CHECK(agrees(separatrix(I, 2, 3000), Vector3d(0, 2, 0), 1e-14));
}

TEST_CASE("first_flip: elliptic integrals, and a root of the integrated motion") {
  CHECK(agrees(first_flip({1, 2, 3}, {0.01, 1, 0.02}), 8.81335954437, 2e-12));
  CHECK(agrees(first_flip({1, 2, 3}, {-0.01, 1, 0.02}), 7.78413896009, 2e-12));
  CHECK(agrees(first_flip({1.2, 1.7, 2.6}, {-0.3, -1.5, 0.05}), 5.83450102219, 2e-12));
  CHECK(agrees(first_flip({1, 2, 3}, {0, 1, 0.1}), 5.41053058614, 2e-12));
}

}  // namespace problems_06
