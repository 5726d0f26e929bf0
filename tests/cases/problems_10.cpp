// Values of the problems of lecture 10, from computations in 34 digits by two ways that share no formula.
#include "tests/cases/problems.hpp"

#include <rigid/attitude_of_a_free_body.hpp>

namespace problems_10 {

const Vector3d body(1.2, 2, 2.7), round_3(0.4, -0.9, 0.6), round_1(0.9, -0.5, 0.2);

TEST_CASE("poinsot: the gradient of the energy, and the tangent plane by differences") {
  CHECK(agrees(poinsot(body, round_3), Vector2d(1.12768940859, 0.241488297347), 1e-11));
  const Vector2d nearly_along = poinsot({1, 2, 3}, {1e-5, 2e-5, 1});
  CHECK(agrees(nearly_along[0], 1.00000000021, 1e-11));
  CHECK(agrees(nearly_along[1], 9.42809041517e-6, 1e-11));
  CHECK(agrees(poinsot({1, 2, 3}, {0, -2, 0}), Vector2d(2, 0), 1e-14));
}

TEST_CASE("azimuth_rate: a symmetric top, and ω along an axis across") {
  CHECK(agrees(azimuth_rate({1, 1, 1.8}, {0.4, 0.3, 2}), std::sqrt(0.25 + 12.96), 1e-14));
  CHECK(agrees(azimuth_rate({1.2, 2, 2.7}, {0, -0.7, 0}), 0.7, 1e-14));
  CHECK(agrees(azimuth_rate(body, round_3), 1.2890162374803, 1e-12));
}

TEST_CASE("herpolhode_radii: two invariants, and the extremes of the integrated motion") {
  CHECK(agrees(herpolhode_radii(body, round_3), Vector2d(0.150867631386, 0.445327517402), 2e-12));
  CHECK(agrees(herpolhode_radii(body, round_1), Vector2d(0.258606927049, 0.357193811902), 2e-12));
  CHECK(agrees(herpolhode_radii({1, 1, 1.8}, {0.4, 0, 2}), Vector2d(0.17669044172, 0.17669044172), 5e-12));
  CHECK(herpolhode_radii({1, 2, 3}, {0, 0, -3}).norm() == 0);
}

TEST_CASE("exact_rotation: elliptic functions, and the remainder of a period by collocation") {
  const double tolerance = 1e-9;  // a million seconds times the last digit of the rate
  CHECK(agrees(exact_rotation(body, round_3, 700000), Vector3d(-0.879399763896, 0.146338402995, 0.819475308631),
               tolerance));
  CHECK(agrees(exact_rotation(body, round_1, 700000), Vector3d(0.891103701637, -0.520083473569, 0.178623743346),
               tolerance));
  CHECK(agrees(exact_rotation(body, round_3, -123456.7), Vector3d(0.654578091769, -0.681777895965, 0.704533159664),
               tolerance));
  CHECK(agrees(exact_rotation(body, {-0.4, 0.1, -0.6}, 500000), Vector3d(0.409166295, 0.0215356426395, -0.603131324019),
               tolerance));
}

TEST_CASE("turn_per_period: the integral of the third kind, and the rate integrated") {
  CHECK(agrees(turn_per_period(body, round_3), 21.0458676193, 5e-12));
  CHECK(agrees(turn_per_period(body, round_1), 16.2678595036, 5e-12));
  CHECK(agrees(turn_per_period({1, 2, 3}, {0.1, 1, 0.1}), 27.4223517061, 5e-12));
  CHECK(agrees(turn_per_period(body, {0.3, 0.02, -1}), 16.0869197147, 5e-12));
}

TEST_CASE("racket_twist: the attitude in space by Taylor series, and the azimuths of handle and L in it") {
  CHECK(agrees(racket_twist(body, round_3), 1.7873214284292, 1e-11));
  CHECK(agrees(racket_twist(body, round_1), 4.0798376937122, 1e-11));
  CHECK(agrees(racket_twist({1.21e-3, 16.38e-3, 17.48e-3}, {0.3, 10, 0.4}), -1.2997284859137, 1e-10));
  CHECK(agrees(racket_twist({1, 2, 2}, {0.4, -0.9, 0.6}), 1.1423973285781, 1e-11));
}

TEST_CASE("geometric_phase: from the turn about L, and the area along the path") {
  CHECK(agrees(geometric_phase(body, round_3), 1.27299602291, 1e-11));
  CHECK(agrees(geometric_phase(body, round_1), 1.78110845585, 1e-11));
  CHECK(agrees(geometric_phase({1, 2, 3}, {0.1, 1, 0.1}), 2.0292049138, 1e-11));
  CHECK(agrees(geometric_phase(body, {-0.9, -0.5, 0.2}), 1.78110845585, 1e-11));
}

TEST_CASE("exact_attitude: elliptic integrals, and the attitude of one period by collocation, raised to a power") {
  const double tolerance = 1e-9;
  CHECK(agrees(exact_attitude(body, round_3, 700000),
               Matrix3d{{-0.670585260966, 0.715064755307, -0.197478615282},
                        {-0.22791442657, -0.451919759878, -0.86245205362},
                        {-0.705953555085, -0.533339410085, 0.46602430378}},
               tolerance));
  CHECK(agrees(exact_attitude(body, round_1, 700000),
               Matrix3d{{0.324402011853, -0.873312283653, -0.363440490212},
                        {-0.222506675699, 0.302987099061, -0.926655058299},
                        {0.919377024933, 0.381476700498, -0.0960281885822}},
               tolerance));
  CHECK(agrees(exact_attitude(body, round_3, -123456.7),
               Matrix3d{{-0.307023555057, -0.911357166571, -0.274161725226},
                        {0.295839158149, 0.182410166531, -0.937659705678},
                        {0.90455277853, -0.368991390259, 0.213610919124}},
               tolerance));
}

}  // namespace problems_10
