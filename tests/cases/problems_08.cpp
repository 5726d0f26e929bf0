// The problems of lecture 08 at inputs whose answers were computed elsewhere, in 34 digits.
#include "tests/cases/problems.hpp"

#include <rigid/kinetic_energy.hpp>

namespace problems_08 {

const Vector3d angles(0.3, 0.7, 1.1), momenta(1.3, -0.4, 0.8);

TEST_CASE("the Hamiltonian of a free body") {
  CHECK(agrees(hamiltonian({1, 2, 3}, angles, momenta), 0.608725276435, digits));
  CHECK(agrees(hamiltonian({2, 2, 3}, angles, momenta), 0.431907023194, digits));
  CHECK(agrees(hamiltonian({1, 2, 3}, angles, {0.8 * std::cos(0.7), 0, 0.8}), 0.106666666667, digits));
  CHECK(agrees(hamiltonian({1, 2, 3}, {0.3, -2.9, 1.1}, momenta), 22.189449484, digits));
}

TEST_CASE("the Poisson brackets of the body components of L") {
  CHECK(agrees(momentum_brackets(angles, momenta),
               Matrix3d{{0, -0.8, 0.770511786504}, {0.8, 0, 0.840995251452}, {-0.770511786504, -0.840995251452, 0}},
               digits));
  CHECK(agrees(momentum_brackets({2, -1.2, 4}, {0.2, 0.5, -1}),
               Matrix3d{{0, 1, 0.129804696172}, {-1, 0, 0.772785522296}, {-0.129804696172, -0.772785522296, 0}},
               digits));
  CHECK(agrees(momentum_brackets(angles, {0, 0, 0}), Matrix3d(Matrix3d::Zero()), 1e-15, 1));
}

TEST_CASE("the energy of a rolling cone") {
  CHECK(agrees(rolling_cone_energy(2, 0.3, 25 * degree, 4), 1.10310530923, digits));
  CHECK(agrees(rolling_cone_energy(2, 0.3, 45 * degree, 4), 0.756, 1e-14));
  CHECK(agrees(rolling_cone_energy(2, 0.3, 1 * degree, 4), 1.29567104659, digits));
}

TEST_CASE("the rate of a settling coin") {
  CHECK(agrees(spinning_coin(0.0375, 9.81, 20 * degree), 55.3124662651, digits));
  CHECK(agrees(spinning_coin(0.0375, 9.81, 1 * degree), 244.861895045, digits));
  CHECK(agrees(spinning_coin(0.0375, 9.81, 80 * degree), 32.5966625083, digits));
}

}  // namespace problems_08
