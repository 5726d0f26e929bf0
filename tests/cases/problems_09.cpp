// The exercises of lecture 09 at inputs whose answers were computed elsewhere, in 34 digits.
#include "tests/cases/problems.hpp"

#include <rigid/heavy_top.hpp>

namespace problems_09 {

namespace {

constexpr double I1 = 4e-4, I3 = 9e-5, mgl = 0.06;  // kg m², kg m², J

bool each_agrees(const Vector2d& actual, double first, double second) {
  return agrees(actual[0], first, digits).holds && agrees(actual[1], second, digits).holds;
}

}  // namespace

TEST_CASE("the effective potential of a heavy top") {
  CHECK(agrees(effective_potential(I1, I3, mgl, 0.012, 0.0137, 0.6), 1.0941247363, digits));
  CHECK(agrees(effective_potential(I1, I3, mgl, 0.0137, 0.0137, 1e-3), 1.10272225088, digits));
  CHECK(agrees(effective_potential(I1, I3, mgl, 0, 0, 2), -0.0249688101928, digits));
}

TEST_CASE("the two steady precessions of a heavy top") {
  CHECK(each_agrees(steady_precession(I1, I3, mgl, 150, 0.5), 5.12829285887, 33.3296271883));
  CHECK(each_agrees(steady_precession(I1, I3, 1e-8, 2000, 0.5), 5.55555555616e-8, 512.77226724));
  CHECK(each_agrees(steady_precession(I1, I3, mgl, -40, 2.5), -9.1743346004, 20.4082754636));
  CHECK(each_agrees(steady_precession(3.28e-4, 6.6e-5, 0.0456, 200, 30 * degree), 3.7585425938, 42.711113219));
}

TEST_CASE("the spin at which a sleeping top wakes") {
  CHECK(agrees(sleeping_spin(I1, I3, mgl), 108.86621079, digits));
  CHECK(agrees(sleeping_spin(1.2e-4, 5e-8, 0.006), 33941.125497, digits));
  CHECK(agrees(sleeping_spin(2e-4, 3e-4, 0.03), 16.3299316186, digits));
}

TEST_CASE("the accelerations of the angles under a weight") {
  const Vector3d I(3.8e-4, 4.4e-4, 9e-5), angles(0.3, 0.7, 1.1), rates(5, -2, 150);
  CHECK(agrees(heavy_top_accelerations(I, mgl, angles, rates), Vector3d(-203.470038831, 12.7809517588, 153.425943744),
               digits));
  CHECK(agrees(heavy_top_accelerations({I1, I1, I3}, mgl, angles, rates),
               Vector3d(-83.7047045494, -2.53253737644, 57.5787124412), digits));
  CHECK(agrees(heavy_top_accelerations(I, mgl, angles, {0, 0, 0}),
               Vector3d(-8.70390865356, 98.8646901776, 6.65711653251), digits));
}

TEST_CASE("limits, period and advance of a nutation") {
  struct Start {
    double theta;
    Vector3d rates;
    double smallest, largest, period, advance;
  };
  for (const auto& [theta, rates, smallest, largest, period, advance] :
       {Start{0.5, {2, 0.5, 150}, 0.497034142671, 0.616255644496, 0.243195305685, 1.21570809274},
        Start{0.5, {0, 0, 150}, 0.5, 0.690997728426, 0.244479289547, 1.22807595591},
        Start{0.5, {-6, 0, 150}, 0.5, 0.92671668588, 0.243477118983, 1.21165423137},
        Start{2.2, {3, 1, 12}, 2.19552280069, 2.88041711591, 0.272599407347, 3.11222427601}}) {
    CHECK(each_agrees(nutation_limits(I1, I3, mgl, theta, rates), smallest, largest));
    CHECK(agrees(nutation_period(I1, I3, mgl, theta, rates), period, digits));
    CHECK(agrees(precession_per_nutation(I1, I3, mgl, theta, rates), advance, digits));
  }
}

TEST_CASE("the precession of Mars") {
  const double spin = 2 * pi / 88642.663, orbital_rate = 2 * pi / (686.98 * 86400);
  const double polar = 1, equatorial = 0.99462;
  CHECK(agrees(planet_precession_rate(equatorial, polar, spin, orbital_rate, 25.19 * degree), -1.15446763494e-12,
               digits));
  CHECK(agrees(planet_precession_rate(equatorial, polar, spin, orbital_rate, 110 * degree), 4.36347216685e-13, digits));
  CHECK(planet_precession_rate(1, 1, spin, orbital_rate, 0.4) == 0);
}

TEST_CASE("the path of a top, from φ̇ at the limits of the nutation") {
  const double small_I1 = 3.28e-4, small_I3 = 6.6e-5, small_mgl = 0.0456, at = 40 * degree;
  const auto type = [&](double push, double spin) { return path_type(small_I1, small_I3, small_mgl, at, push, spin); };
  CHECK(type(0, 200) == 0);
  CHECK(type(6.5, 200) == 1);
  CHECK(type(7.5, 200) == -1);
  CHECK(type(22.7, 200) == -1);
  CHECK(type(22.9, 200) == 1);
  CHECK(type(-4, 200) == -1);
  CHECK(type(4, -200) == -1);
}

TEST_CASE("nutation about steady precessions: periods by elliptic integrals, extrapolated to no amplitude") {
  const auto frequency = [](double theta, double rate) { return nutation_frequency(3.28e-4, 0.0456, theta, rate); };
  CHECK(agrees(frequency(30 * degree, 3.7585425938), 33.786220998282, digits));
  CHECK(agrees(frequency(30 * degree, 20), 14.405628945416, digits));
  CHECK(agrees(frequency(30 * degree, -5), 23.607497451315, digits));
  CHECK(agrees(frequency(150 * degree, -30), 34.092119613011, digits));
}

TEST_CASE("least rolling speeds: where the equations of a rolling wheel, differentiated in 30 digits, stop growing") {
  CHECK(agrees(least_rolling_speed(1, 1, 0.5, 0.25), 0.5773502691896, digits));
  CHECK(agrees(least_rolling_speed(1, 1, 0.6, 2), 1.443375672974, digits));
}

TEST_CASE("attitudes held by gravity: eigenvalues of the equations of motion, differentiated in 30 digits") {
  CHECK(agrees(attitude_frequencies({2, 3, 4}, 1), Vector3d(0.8660254037844, 0.6817743332746, 1.69366971155), digits));
  CHECK(
      agrees(attitude_frequencies({2, 20, 21}, 1), Vector3d(1.603567451475, 0.7044464794919, 1.956720510837), digits));
  CHECK(agrees(attitude_frequencies({0.75, 1, 0.7}, 1), Vector3d(1.035098339014, 0.3232768822647, 0.8749240294981),
               digits));
}

TEST_CASE("moon_libration: orbit and rotation together, by Taylor series") {
  CHECK(each_agrees(moon_libration(0.25, 0.1, 1, 0.3, 1, 12), 12.046121045592, 0.36504194541562));
  CHECK(each_agrees(moon_libration(0.3, 0.3, 1, 0.5, 1.5, 7), 6.2079969838558, 1.4711697068644));
  CHECK(each_agrees(moon_libration(0.1, 0, 1, 0.2, 1, 5), 4.8181293566679, 0.95498113081172));
}

}  // namespace problems_09
