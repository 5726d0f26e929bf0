// Worked values of the problems of lecture 02, computed elsewhere in 34 digits by two routes each.
#include "tests/cases/problems.hpp"

#include <rigid/rotating_frames.hpp>

namespace problems_02 {

constexpr double rate = 7.292115e-5;

TEST_CASE("apparent_gravity") {
  const double R = 6.371e6, g0 = 9.83;
  CHECK(agrees(apparent_gravity(40 * degree, R, g0, rate, {180, -120}),
               Vector3d(-0.011249474809, -0.0335557501134, -9.78266402866), digits));
  CHECK(agrees(apparent_gravity(45 * degree, R, g0, rate, {0, 0}), Vector3d(0, -0.0169388775107, -9.81306112249),
               digits));
  CHECK(agrees(apparent_gravity(0, R, g0, rate, {0, 0}), Vector3d(0, 0, -9.79612224498), digits));
  CHECK(
      agrees(apparent_gravity(-90 * degree, R, g0, rate, {0, 100}), Vector3d(-0.01458423, 0, -9.82843038769), digits));
}

TEST_CASE("shell_drift") {
  CHECK(agrees(shell_drift(49.5 * degree, 232 * degree, 120e3, 176, 9.81, rate), 1430.9908358, digits * 10));
  CHECK(agrees(shell_drift(0, 0, 20e3, 60, 9.81, rate), -25.752833334, digits * 10));
  CHECK(agrees(shell_drift(0, 90 * degree, 20e3, 60, 9.81, rate), 0.0, digits, 25));
  CHECK(agrees(shell_drift(-35 * degree, 180 * degree, 20e3, 60, 9.81, rate), -29.0955379502, digits));
}

TEST_CASE("foucault_path") {
  const double g = 9.81;
  CHECK(agrees(foucault_path({2, -1}, 67, g, 48.8462 * degree, rate, 604), Vector2d(0.411717160535, -0.223576933012),
               digits));
  CHECK(agrees(foucault_path({2, -1}, 67, g, -30 * degree, rate, 1500), Vector2d(-1.2058874915, 0.52243343848),
               digits * 10));
  CHECK(agrees(foucault_path({2, -1}, 67, g, 0, rate, 604), Vector2d(0.419039561283, -0.209519780641), digits));
  CHECK(
      agrees(foucault_path({1, 0}, 30, g, 90 * degree, rate, 900), Vector2d(0.842249059416, -0.0554240190387), digits));
}

TEST_CASE("bead_on_hoop") {
  CHECK(agrees(bead_on_hoop(0.5, 9.81, 7), Vector2d(1.15883409479, 6.41435825603), digits));
  CHECK(agrees(bead_on_hoop(0.5, 9.81, 3), Vector2d(0, 3.25883414736), digits));
  CHECK(agrees(bead_on_hoop(0.5, 9.81, 0), Vector2d(0, 4.42944691807), digits));
  CHECK(agrees(bead_on_hoop(0.5, 9.81, -60), Vector2d(1.56534629981, 59.9991089184), digits));
}

TEST_CASE("tide: the root of the exact potential, and of its series in 34 digits") {
  CHECK(agrees(tide(0.0123, 6.371e6, 3.844e8, 0), 0.541127428086987, 1e-11));
  CHECK(agrees(tide(0.0123, 6.371e6, 3.844e8, std::acos(-1)), 0.529298124928917, 1e-11));
  CHECK(agrees(tide(0.0123, 6.371e6, 3.844e8, std::acos(0.5)), 0.13113598295651, 1e-11));
  CHECK(agrees(tide(332946, 6.371e6, 1.496e11, 0.5), 0.189270388813548, 1e-10));
  CHECK(agrees(tide(0.12, 1.2e6, 6e6, 2.2), 651.228904366942, 1e-12));
}

}  // namespace problems_02
