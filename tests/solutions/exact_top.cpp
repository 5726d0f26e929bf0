// The exact top judges the students' integrators, so it is judged here: by an integrator of another kind, by Boost's
// elliptic functions, by the conservation laws, and by numbers computed elsewhere.
#include "solutions/judging/exact_top.hpp"
#include "lectures/support/agrees.hpp"
#include "rigid/attitude_of_a_free_body.hpp"
#include "rigid/euler_equations.hpp"
#include "solutions/judging/random.hpp"

#include <doctest/doctest.h>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/numeric/odeint.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using Eigen::Vector3d;
using Eigen::VectorXd;
using workbook::agrees;
using workbook::judging::exact_free_rotation;
using workbook::judging::ExactTop;
using workbook::judging::jacobi_amplitude;

namespace {

/// ω in the body, followed by a Runge-Kutta method of order 8.
Vector3d followed(const Vector3d& I, const Vector3d& omega0, double t) {
  using State = std::array<double, 3>;
  const auto rate = [&I](const State& y, State& dy, double) {
    const Vector3d omega(y[0], y[1], y[2]);
    const Vector3d omega_rate = I.cwiseProduct(omega).cross(omega).cwiseQuotient(I);
    dy = {omega_rate.x(), omega_rate.y(), omega_rate.z()};
  };
  State y = {omega0.x(), omega0.y(), omega0.z()};
  using namespace boost::numeric::odeint;
  if (t != 0) {
    integrate_adaptive(make_controlled(1e-14, 1e-14, runge_kutta_fehlberg78<State>()), rate, y, 0.0, t,
                       t > 0 ? 1e-3 : -1e-3);
  }
  return {y[0], y[1], y[2]};
}

void check_against_integration(const Vector3d& I, const Vector3d& omega0, double t, double tolerance = 1e-11) {
  CAPTURE(I.transpose());
  CAPTURE(omega0.transpose());
  CAPTURE(t);
  CHECK(agrees(ExactTop(I, omega0).omega(t), followed(I, omega0, t), tolerance, omega0.norm()));
}

}  // namespace

TEST_CASE("The amplitude agrees with Boost's elliptic functions, which take the modulus first") {
  for (const double complement : {1.0, 0.9, 0.5, 0.1, 1e-3}) {
    for (const double u : {-30.0, -2.5, -1e-9, 0.0, 0.3, 4.0, 25.0}) {
      CAPTURE(complement);
      CAPTURE(u);
      double cn = 0, dn = 0;
      const double sn = boost::math::jacobi_elliptic(std::sqrt(1 - complement), u, &cn, &dn);
      const double angle = jacobi_amplitude(u, complement);
      CHECK(agrees(std::sin(angle), sn, 1e-12, 1));
      CHECK(agrees(std::cos(angle), cn, 1e-12, 1));
    }
  }
}

TEST_CASE("The amplitude grows by half a turn in half a period, however close to the separatrix") {
  for (const double complement : {0.7, 1e-6, 1e-12, 1e-20}) {
    // K(k) loses its digits when 1 − k² is small, so its expansion stands in there: K ≈ ½ ln(16 / (1 − m)).
    const double K = complement > 1e-3 ? boost::math::ellint_1(std::sqrt(1 - complement))
                                       : 0.5 * std::log(16 / complement) * (1 + complement / 4) - complement / 4;
    CAPTURE(complement);
    CHECK(agrees(jacobi_amplitude(2 * K, complement), std::numbers::pi, 1e-8));
    CHECK(agrees(jacobi_amplitude(6 * K, complement), 3 * std::numbers::pi, 1e-8));
  }
}

TEST_CASE("On the separatrix the amplitude is the Gudermannian") {
  CHECK(agrees(std::sin(jacobi_amplitude(1.3, 0)), std::tanh(1.3), 1e-15));
  CHECK(agrees(std::cos(jacobi_amplitude(-1.3, 0)), 1 / std::cosh(1.3), 1e-15));
}

TEST_CASE(
    "About the axis of the largest moment, and about the smallest, the exact top has the numbers of an independent "
    "computation") {
  const Vector3d I(1, 2, 3);
  const ExactTop tumbling(I, Vector3d(0.1, 1, 0.1));
  CHECK(agrees(1 - tumbling.complementary_parameter(), 0.980582524272, 1e-12));
  CHECK(agrees(tumbling.rate(), 0.585946527708, 1e-12));
  CHECK(agrees(tumbling.period(), 22.996262944122, 1e-13));
  CHECK(agrees(tumbling.omega(20), Vector3d(.6760625658002, .7435989558382, .3987733662439), 1e-12));

  const ExactTop spinning(I, Vector3d(1, .5, .25));
  CHECK(agrees(1 - spinning.complementary_parameter(), 0.35, 1e-13));
  CHECK(agrees(spinning.period(), 10.809345300803, 1e-13));
  CHECK(agrees(spinning.omega(20), Vector3d(1.1135114730861, -.1004599388101, .3774510125806), 1e-12));
}

TEST_CASE("V20: the exact top and the reference integration both reach the published end of DETEST's problem B5") {
  // W. H. Enright and J. D. Pryce, as in the worked examples of lecture 05, where a student's integration is allowed
  // 1e-6.
  const Vector3d I(2, 3, 1), c(std::sqrt(1.53), std::sqrt(0.51), std::sqrt(3.0));
  const Vector3d start = c.cwiseProduct(Vector3d(0, 1, 1));
  const Vector3d published(-0.9396570798729192, -0.3421177754000779, 0.7414126596199957);
  CHECK(agrees(ExactTop(I, start).omega(20).cwiseQuotient(c), published, 1e-13));
  const Vector3d integrated = rigid::free_rotation(I, start, VectorXd{{20}});
  CHECK(agrees(integrated.cwiseQuotient(c), published, 1e-12));
}

TEST_CASE("In every order of the moments and with every sign of the start the exact top follows the integration") {
  std::array<int, 3> order = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      for (const Vector3d& start : {Vector3d(.8, .5, .3), Vector3d(.2, .5, .7)}) {
        Vector3d I, omega0;
        const Vector3d ascending(1.1, 1.7, 2.4);
        for (int i = 0; i < 3; ++i) {
          I[i] = ascending[order[i]];
          omega0[i] = start[order[i]] * ((signs >> i & 1) ? -1 : 1);
        }
        for (const double t : {7.3, -4.1}) check_against_integration(I, omega0, t);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("Random tops agree with the integration for many turns") {
  workbook::judging::Random random(20);
  for (int i = 0; i < 20; ++i) {
    const Vector3d I = random.principal_moments();
    const Vector3d omega0 = random.vector(2.0);
    check_against_integration(I, omega0, random.uniform(-20, 20), 1e-9);
  }
}

TEST_CASE("A start with one component zero is not a special case") {
  for (const Vector3d& omega0 : {Vector3d(0, 1, 0.4), Vector3d(0.4, 1, 0), Vector3d(0.3, 0, 0.9), Vector3d(0.9, 0, 0.3),
                                 Vector3d(0, -1, 0.4), Vector3d(-0.4, -1, 0)}) {
    for (const double t : {0.0, 3.0, -11.0}) check_against_integration(Vector3d(1, 2, 2.5), omega0, t);
  }
}

TEST_CASE("A symmetric top turns its ω uniformly, whichever axis is the axis of symmetry") {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double moment : {0.5, 1.8}) {  // prolate and oblate
      Vector3d I = Vector3d::Ones();
      I[axis] = moment;
      check_against_integration(I, Vector3d(0.7, -0.4, 0.9), 6.0);
      const ExactTop top(I, Vector3d(0.7, -0.4, 0.9));
      CHECK(agrees(top.complementary_parameter(), 1, 1e-15));
      const double body_rate = Vector3d(0.7, -0.4, 0.9)[axis] * (moment - 1);
      CHECK(agrees(top.period(), 2 * std::numbers::pi / std::abs(body_rate), 1e-14));
    }
  }
}

TEST_CASE("Two moments may be nearly equal") {
  for (const double difference : {1e-4, 1e-9, 1e-15}) {
    check_against_integration(Vector3d(1, 1 + difference, 1.5), Vector3d(0.3, 0.5, 0.8), 9.0);
    check_against_integration(Vector3d(1, 1.5, 1.5 + difference), Vector3d(0.6, 0.5, 0.4), -9.0);
    check_against_integration(Vector3d(1, 1.5, 1.5 + difference), Vector3d(0, 0.5, 0.4), 9.0);
  }
}

TEST_CASE("A sphere, a principal axis and a body at rest rotate steadily") {
  const ExactTop sphere(Vector3d(2, 2, 2), Vector3d(0.3, -0.2, 0.5));
  CHECK(agrees(sphere.omega(17), Vector3d(0.3, -0.2, 0.5), 1e-16));
  CHECK(sphere.period() == 0.0);
  check_against_integration(Vector3d(2, 2, 2), Vector3d(0.3, -0.2, 0.5), 5.0);
  for (int axis = 0; axis < 3; ++axis) check_against_integration(Vector3d(1, 2, 2.5), 0.8 * Vector3d::Unit(axis), -3.0);
  const ExactTop resting(Vector3d(1, 2, 2.5), Vector3d::Zero());
  CHECK(agrees(resting.omega(5), Vector3d::Zero(), 0, 1));
}

TEST_CASE("On the separatrix the middle axis is approached once and for ever") {
  // I_c (I_c − I_b) = I_a (I_b − I_a) here, so ω_a = ±ω_c lies on the separatrix without rounding.
  const Vector3d I(3, 5, 6);
  for (const Vector3d& omega0 : {Vector3d(.5, .25, .5), Vector3d(-.5, .25, .5), Vector3d(.5, -.25, -.5)}) {
    const ExactTop top(I, omega0);
    CHECK(top.complementary_parameter() == 0.0);
    CHECK(top.period() == std::numeric_limits<double>::infinity());
    for (const double t : {2.5, -6.0, 12.0}) check_against_integration(I, omega0, t, 1e-10);
    const double speed = std::sqrt(I.cwiseProduct(omega0).squaredNorm()) / I[1];  // all of L along the middle axis
    CHECK(agrees(std::abs(top.omega(500)[1]), speed, 1e-14));
  }
}

TEST_CASE("Next to the separatrix the body still turns over in the right moment") {
  // Half a period, 2K/λ, as computed elsewhere for these two starts.
  CHECK(agrees(ExactTop(Vector3d(1, 2, 3), Vector3d(0, 1, 1e-3)).period() / 2, 26.828560929, 1e-10));
  CHECK(agrees(ExactTop(Vector3d(1, 2, 3), Vector3d(1e-3, 1, 0)).period() / 2, 28.731424437, 1e-10));
  const ExactTop close(Vector3d(1, 2, 3), Vector3d(0, 1, 1e-9));
  CHECK(agrees(close.omega(close.period() / 2), Vector3d(0, -1, 1e-9), 1e-9));
  CHECK(agrees(close.omega(close.period()), Vector3d(0, 1, 1e-9), 1e-9));
  check_against_integration(Vector3d(1, 2, 3), Vector3d(0, 1, 1e-3), 40.0, 1e-8);
  check_against_integration(Vector3d(1, 2, 3), Vector3d(0, 1, 1e-6), 30.0, 1e-8);
}

TEST_CASE("Energy and the square of the angular momentum are conserved") {
  workbook::judging::Random random(5);
  for (int i = 0; i < 20; ++i) {
    const Vector3d I = random.principal_moments();
    const Vector3d omega0 = random.vector(1.5);
    const double t = random.uniform(-300, 300);
    const ExactTop top(I, omega0);
    const Vector3d omega = top.omega(t);
    CHECK(agrees(I.dot(omega.cwiseAbs2()), I.dot(omega0.cwiseAbs2()), 1e-13));
    CHECK(agrees(I.cwiseProduct(omega).squaredNorm(), I.cwiseProduct(omega0).squaredNorm(), 1e-13));
    CHECK(agrees(top.omega(t + top.period()), omega, 1e-10));
  }
}

TEST_CASE("The answer to the exercise has one column per time, in the order given") {
  const Vector3d I(1, 2, 2.5), omega0(0.2, 0.9, -0.3);
  const ExactTop top(I, omega0);
  const auto columns = exact_free_rotation(I, omega0, VectorXd{{3.0, -1.0, 0.0, 3.0}});
  REQUIRE(columns.cols() == 4);
  CHECK(agrees(columns.col(0), top.omega(3), 0));
  CHECK(agrees(columns.col(1), top.omega(-1), 0));
  CHECK(agrees(columns.col(2), omega0, 1e-15));
  CHECK(agrees(columns.col(3), columns.col(0), 0));
  CHECK(exact_free_rotation(I, omega0, VectorXd(0)).cols() == 0);
}

TEST_CASE("The elliptic functions give the start back where one of them is zero, and at every quarter of a period") {
  const Vector3d I(1, 2, 3);
  for (const Vector3d& start : {Vector3d(0, 1, 1), Vector3d(1, 1, 0), Vector3d(0.5, 0, 2), Vector3d(0.1, 1, 0)}) {
    CAPTURE(start.transpose());
    CHECK(agrees(rigid::exact_rotation(I, start, 0), start, 1e-14));
    const double quarter = ExactTop(I, start).period() / 4;
    for (int n = -3; n <= 4; ++n) {
      CAPTURE(n);
      CHECK(agrees(rigid::exact_rotation(I, start, n * quarter), followed(I, start, n * quarter), 1e-11));
      const Vector3d L =
          rigid::exact_attitude(I, start, n * quarter) * I.cwiseProduct(rigid::exact_rotation(I, start, n * quarter));
      CHECK(agrees(L, I.cwiseProduct(start), 1e-11));
    }
  }
}
