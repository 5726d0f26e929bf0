// Worked examples of lecture 10. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/motion.hpp"
#include "lectures/support/result.hpp"

#include <rigid/attitude_of_a_free_body.hpp>
#include <rigid/euler_equations.hpp>
#include <rigid/free_tops.hpp>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace rigid;
using workbook::agrees;
using workbook::integrated;
using workbook::Motion;
using workbook::result;
using workbook::result_table;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

/// An evenly filled crate of 10 kg, 1.45 m × 1.07 m × 0.55 m: its moments, kg m², and two motions, round axis 3 and
/// round axis 1, rad/s.
const Vector3d crate(1.2, 2, 2.7), about_3(0.4, -0.9, 0.6), about_1(0.9, -0.5, 0.2);

/// A tennis racket, kg m²: axis 1 along the handle, axis 3 out of the strings.
const Vector3d racket(1.21e-3, 16.38e-3, 17.48e-3);

Vector3d L_of(const Vector3d& I, const Vector3d& omega) { return I.cwiseProduct(omega); }
double twice_T(const Vector3d& I, const Vector3d& omega) { return I.dot(omega.cwiseAbs2()); }

/// The angle through which a vector has gone round the axis L, from −π to π.
double angle_about(const Vector3d& L, const Vector3d& before, const Vector3d& after) {
  const Vector3d across = L.cross(before).normalized(), across_then = L.cross(after).normalized();
  return std::atan2(L.normalized().dot(across.cross(across_then)), across.dot(across_then));
}

/// How far axis `axis` of the body goes round L in a time, whole turns counted, by following the integrated attitude.
double followed_about_L(const Vector3d& I, const Vector3d& omega0, double time, int axis) {
  const Vector3d L = L_of(I, omega0);
  constexpr int steps = 400;
  double angle = 0;
  Motion now{omega0};
  for (int i = 0; i < steps; ++i) {
    const Motion next = integrated(I, now, time / steps);
    angle += angle_about(L, now.A.col(axis), next.A.col(axis));
    now = next;
  }
  return angle;
}

/// The size of the twist of a racket thrown with ω off axis 2 by two angles, towards axis 1 and towards axis 3; all
/// angles in degrees.
double twist_of_throw(const Vector3d& I, double towards_1, double towards_3) {
  const Vector3d omega0(std::tan(towards_1 * degree), 1, std::tan(towards_3 * degree));
  return std::abs(racket_twist(I, omega0)) / degree;
}

}  // namespace

// ---- Poinsot's picture

//! [plane]
TEST_CASE("plane: The ellipsoid touches a plane that stands still, at a place that moves") {
  //! [plane in brief]
  const Vector3d I(1.2, 2, 2.7), omega0(0.4, -0.9, 0.6);  // kg m², rad/s
  const double height = poinsot(I, omega0)[0];
  const double radius = poinsot(I, omega0)[1];
  const Vector3d later = exact_rotation(I, omega0, 3);
  const double radius_then = poinsot(I, later)[1];
  //! [plane in brief]

  // In space L is where it was, and so is the plane: every point of it has the component 2T/L along L.
  const Motion moved = integrated(I, {omega0}, 3);
  const Vector3d L = L_of(I, omega0), contact = moved.A * moved.omega;
  CHECK(agrees(contact.dot(L.normalized()), height, 1e-12));
  CHECK(agrees(poinsot(I, later)[0], height, 1e-13));
  CHECK(agrees((contact - height * L.normalized()).norm(), radius_then, 1e-11));
  // It is a tangent plane: no point of the ellipsoid, turned into space, lies beyond it.
  for (int i = 0; i < 200; ++i) {
    const Vector3d direction(std::sin(i), std::cos(2.3 * i), std::sin(0.7 * i + 1));
    const Vector3d on_ellipsoid = direction * std::sqrt(twice_T(I, omega0) / twice_T(I, direction));
    CHECK((moved.A * on_ellipsoid).dot(L.normalized()) <= height + 1e-13);
  }

  result("h", height, "rad/s", "the distance of the plane from the centre", 4);
  result(R"(\rho)", radius, "rad/s", "from the foot of the perpendicular to the point of contact", 4);
  result(R"(\rho)", radius_then, "rad/s", "3 s later", 4);
}
//! [plane]

TEST_CASE("The ellipsoid rolls without slipping: polhode and herpolhode have equal lengths") {
  const double P = tumbling_period(crate, about_3);
  constexpr int steps = 4000;
  double on_body = 0, on_plane = 0;
  Motion now{about_3};
  for (int i = 0; i < steps; ++i) {
    const Motion next = integrated(crate, now, P / steps);
    on_body += (next.omega - now.omega).norm();
    on_plane += (next.A * next.omega - now.A * now.omega).norm();
    now = next;
  }
  CHECK(agrees(on_body, on_plane, 2e-6));  // chords for arcs
}

//! [ring]
TEST_CASE("ring: The herpolhode stays between two circles and touches both") {
  //! [ring in brief]
  const Vector3d I(1.2, 2, 2.7);                                   // kg m²
  const Vector2d round_3 = herpolhode_radii(I, {0.4, -0.9, 0.6});  // rad/s
  const Vector2d round_1 = herpolhode_radii(I, {0.9, -0.5, 0.2});
  //! [ring in brief]

  for (const Vector3d& start : {about_3, about_1}) {
    double smallest = 1e9, largest = 0;
    for (int i = 0; i < 4000; ++i) {
      const double radius = poinsot(crate, exact_rotation(crate, start, tumbling_period(crate, start) * i / 4000))[1];
      smallest = std::min(smallest, radius);
      largest = std::max(largest, radius);
    }
    CHECK(agrees(Vector2d(smallest, largest), herpolhode_radii(crate, start), 1e-5));
  }

  result(R"((\rho_{\min}, \rho_{\max}))", round_3, "rad/s", "round axis 3", 4);
  result(R"((\rho_{\min}, \rho_{\max}))", round_1, "rad/s", "round axis 1", 4);
}
//! [ring]

TEST_CASE("The herpolhode of a real body always bends towards the foot; that of impossible moments need not") {
  // L · (velocity × acceleration) of the tip of ω in space, by components on the axes of the body.
  const auto bend = [](const Vector3d& I, const Vector3d& omega) {
    const Vector3d L = L_of(I, omega), velocity = L.cross(omega).cwiseQuotient(I);
    const Vector3d jerk = (L_of(I, velocity).cross(omega) + L.cross(velocity)).cwiseQuotient(I);
    const Vector3d acceleration = jerk + omega.cross(velocity);
    return L.dot(velocity.cross(acceleration));
  };
  for (int i = 0; i < 20000; ++i) {
    const auto spread = [i](double step) { return 0.01 + std::abs(std::sin(step * i)); };  // of mass along an axis
    const double x = spread(1), y = spread(1.7), z = spread(2.9);
    CHECK(bend({y + z, z + x, x + y}, {std::sin(0.3 * i), std::sin(0.77 * i + 1), std::sin(1.31 * i + 2)}) >= 0);
  }
  CHECK(bend({0.3, 0.75, 1.4}, {0.8, -0.8, -0.06}) < 0);  // 1.4 > 0.3 + 0.75
}

// ---- exact motion

//! [days]
TEST_CASE("days: Errors of an integration grow with the time; the exact solution loses only the digits of the phase") {
  Eigen::MatrixXd table(4, 3);
  //! [days in brief]
  const Vector3d I(1.2, 2, 2.7), omega0(0.4, -0.9, 0.6);  // kg m², rad/s
  const double P = tumbling_period(I, omega0);
  int row = 0;
  for (const double t : {1e1, 1e2, 1e3, 1e4}) {  // s
    const double rest = std::fmod(t, P);
    const Vector3d exact = exact_rotation(I, omega0, t);
    const Vector3d in_steps = free_rotation(I, omega0, VectorXd{{t}});
    const Vector3d shortened = free_rotation(I, omega0, VectorXd{{rest}});
    const double error = (in_steps - exact).norm();
    table.row(row++) << t, error, (shortened - exact).norm();
  }
  const Vector3d after_eight_days = exact_rotation(I, omega0, 7e5);
  //! [days in brief]

  CHECK(table.col(2).maxCoeff() < 1e-7);
  CHECK(agrees(after_eight_days, Vector3d(-0.879399763896, 0.146338402995, 0.819475308631), 1e-9));
  CHECK(agrees(after_eight_days, integrated(I, {omega0}, std::fmod(7e5, P)).omega, 1e-9));
  // What one has, one may continue: the motion from t is the motion from the ω reached there.
  CHECK(agrees(exact_rotation(I, exact_rotation(I, omega0, 4e5), 3e5), after_eight_days, 1e-9));
  CHECK(agrees(exact_rotation(I, after_eight_days, -7e5), omega0, 1e-9));

  result_table(
      {R"(\(t\) / s)", "integrated all the way: error / (rad/s)", R"(only \(t\) modulo \(P\): error / (rad/s))"}, table,
      2);
  result("P", P, "s", R"(the period of \(\vec\omega\) in the body)", 4);
  result(R"(\vec\omega)", after_eight_days, "rad/s", "after 700 000 s, eight days");
}
//! [days]

//! [third]
TEST_CASE("third: The elliptic integral of the third kind, from a library and by a sum") {
  //! [third in brief]
  const double k = 0.6, n = -2, alpha = 1.2;
  const double from_library = boost::math::ellint_3(k, n, alpha);
  const int steps = 1000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double s = std::sin(alpha * (i + 0.5) / steps);
    sum += alpha / steps / ((1 - n * s * s) * std::sqrt(1 - k * k * s * s));
  }
  //! [third in brief]

  CHECK(agrees(from_library, sum, 1e-6));
  result(R"(\Pi(n; \alpha, k))", from_library, "", R"(with \(n = -2\), \(\alpha = 1.2\), \(k = 0.6\))", 6);
  result(R"(\Pi(n; \alpha, k))", sum, "", "the integral as a sum over 1000 steps", 6);
}
//! [third]

TEST_CASE("How far axis 3 has gone round L, by the elliptic integral of the third kind and by a sum") {
  using boost::math::ellint_1, boost::math::ellint_3;
  const Vector3d I(1, 2, 3), omega0(0.1, 1, 0.1);  // kg m², rad/s; round axis 3
  const double L = I.cwiseProduct(omega0).norm(), L2 = L * L;
  const double twice_energy = I.dot(omega0.cwiseAbs2());
  const double below = twice_energy * I[2] - L2, above = L2 - twice_energy * I[0];
  const double nu = std::sqrt(above * (I[2] - I[1]) / I.prod());
  const double k = std::sqrt(below * (I[1] - I[0]) / (above * (I[2] - I[1])));
  const double n = -k * k * I[2] * above / (I[0] * below);
  const auto amplitude = [&](const Vector3d& w) {  // am u but for whole turns
    const double sine = w[1] * std::sqrt(I[1] * (I[2] - I[1]));
    return std::atan2(sine, w[0] * std::sqrt(I[0] * (I[2] - I[0])));
  };
  const double from = amplitude(omega0);
  const double to = amplitude(exact_rotation(I, omega0, 20)) + 2 * pi;
  const double more = ellint_3(k, n, to) - ellint_3(k, n, from);
  const double phi = L / I[2] * (20 + (I[2] - I[0]) / (I[0] * nu) * more);

  // u has grown by nu · 20, less than the 4K of a whole period; the arctangent has lost one turn.
  CHECK(nu * 20 < 4 * ellint_1(k));
  CHECK(agrees(ellint_1(k, to) - ellint_1(k, from), nu * 20, 1e-12));
  CHECK(agrees(phi, 24.258871956344, 1e-12));
  double sum = 0;
  constexpr int steps = 4000;
  for (int i = 0; i < steps; ++i) {
    const Vector3d omega = exact_rotation(I, omega0, 20.0 * (i + 0.5) / steps), L_body = L_of(I, omega);
    sum += 20.0 / steps * L * (L_body[0] * omega[0] + L_body[1] * omega[1]) / L_body.head<2>().squaredNorm();
  }
  CHECK(agrees(phi, sum, 1e-5));
  CHECK(agrees(phi, followed_about_L(I, omega0, 20, 2), 1e-9));
  // The other kind of motion has the same integral with n = −cot² and its own k.
  const double turn = turn_per_period(crate, about_1);
  CHECK(agrees(turn, followed_about_L(crate, about_1, tumbling_period(crate, about_1), 2), 1e-10));
}

//! [attitude]
TEST_CASE("attitude: Where the crate is after eight days") {
  //! [attitude in brief]
  const Vector3d I(1.2, 2, 2.7), omega0(0.4, -0.9, 0.6);  // kg m², rad/s
  const Matrix3d A = exact_attitude(I, omega0, 7e5);
  const Vector3d omega = exact_rotation(I, omega0, 7e5);
  const Vector3d L = I.cwiseProduct(omega0);
  const double L_error = (A * I.cwiseProduct(omega) - L).norm() / L.norm();
  //! [attitude in brief]

  CHECK(L_error < 1e-9);
  // A whole period is a turn about L; so 700 000 s are many such turns and the rest of a period.
  const double P = tumbling_period(I, omega0), whole = std::floor(7e5 / P);
  const Eigen::AngleAxisd turns(std::fmod(whole * turn_per_period(I, omega0), 2 * pi), L.normalized());
  CHECK(agrees(turns.toRotationMatrix() * integrated(I, {omega0}, 7e5 - whole * P).A, A, 1e-8));
  CHECK(agrees(exact_attitude(I, omega0, 12), free_attitude(I, omega0, 12), 1e-9));

  result(R"(\mat A)", A, "", "the principal axes are its columns", 4);
  result(R"(|\mat A\,\Inertia\cdot\tilde{\vec\omega} - \vec L|/L)", L_error, "",
         R"(\(\vec L\) has stayed where it was)", 1);
}
//! [attitude]

// ---- the turn about L

//! [turn]
TEST_CASE("turn: After a period ω is back in the body, and the body has turned about L") {
  //! [turn in brief]
  const Vector3d I(1.2, 2, 2.7), omega0(0.4, -0.9, 0.6);  // kg m², rad/s
  const double P = tumbling_period(I, omega0);
  const double turn = turn_per_period(I, omega0);
  const double whole_turns = std::floor(turn / (2 * pi));
  const double rest = turn - 2 * pi * whole_turns;
  //! [turn in brief]

  for (const Vector3d& start : {about_3, about_1}) {
    const double period = tumbling_period(crate, start), expected = turn_per_period(crate, start);
    const Vector3d L = L_of(crate, start);
    const Matrix3d A = integrated(crate, {start}, period).A;
    CHECK(agrees(A * L, L, 1e-11));
    CHECK(agrees(A, Eigen::AngleAxisd(expected, L.normalized()).toRotationMatrix(), 1e-10));
    // A(t + P) = A(P) A(t)
    CHECK(agrees(exact_attitude(crate, start, period + 5), A * exact_attitude(crate, start, 5), 1e-9));
    // Followed all the way, axis 1 goes round L exactly once less than axis 3.
    CHECK(agrees(followed_about_L(crate, start, period, 2), expected, 1e-10));
    CHECK(agrees(followed_about_L(crate, start, period, 0), expected - 2 * pi, 1e-10));
  }

  result("P", P, "s", "the period", 4);
  result(R"(\Delta\phi)", turn, "rad", "by which axis 3 goes round in a period", 4);
  result(R"(\Delta\phi/2\pi)", turn / (2 * pi), "", "turns", 4);
  result(R"(\Delta\phi - 2\pi\cdot3)", rest / degree, "°", "all that the attitude shows of it", 4);
}
//! [turn]

//! [return]
TEST_CASE("return: The attitude never repeats, but comes as close to it as one likes") {
  const Vector3d I = crate, omega0 = about_3;
  Eigen::MatrixXd table(4, 3);
  //! [return in brief]
  const double turn = turn_per_period(I, omega0), P = tumbling_period(I, omega0);
  double closest = pi;
  int row = 0;
  for (int periods = 1; row < 4; ++periods) {
    const double off = std::abs(std::remainder(periods * turn, 2 * pi));
    if (off > closest / 4) continue;  // much closer than ever before
    closest = off;
    table.row(row++) << periods, periods * P / 60, off / degree;
  }
  //! [return in brief]

  for (int i = 0; i < 4; ++i) {
    const Matrix3d A = exact_attitude(I, omega0, table(i, 0) * P);
    CHECK(agrees(Eigen::AngleAxisd(A).angle() / degree, table(i, 2), 1e-6, 1));
  }
  result_table({"periods", "time / min", "off the first attitude / °"}, table, 4);
}
//! [return]

// ---- dynamics and geometry

//! [phases]
TEST_CASE("phases: The turn about L is 2TP/L less or more a solid angle") {
  Eigen::MatrixXd table(4, 6);
  //! [phases in brief]
  const Vector3d I(1.2, 2, 2.7);  // kg m²
  const Vector3d starts[] = {{0.4, -0.9, 0.6},
                             {0.05, 0.03, 1},  // round axis 3
                             {0.9, -0.5, 0.2},
                             {1, 0.03, 0.05}};  // round axis 1
  int row = 0;
  for (const Vector3d& omega0 : starts) {  // rad/s
    const double L = I.cwiseProduct(omega0).norm();
    const double twice_energy = I.dot(omega0.cwiseAbs2());
    const double dynamic = twice_energy * tumbling_period(I, omega0) / L;
    const double turn = turn_per_period(I, omega0);
    const double S = geometric_phase(I, omega0);
    table.row(row++) << omega0.transpose(), turn, dynamic, S;
  }
  //! [phases in brief]

  for (int i = 0; i < 4; ++i) {
    const double geometric = table(i, 3) - table(i, 4);
    CHECK(agrees(i < 2 ? 2 * pi - geometric : geometric, table(i, 5), 1e-9, 1));
    CHECK(agrees(table(i, 3),
                 followed_about_L(I, table.row(i).head<3>(), tumbling_period(I, table.row(i).head<3>()), 2), 1e-9));
  }
  result_table({R"(\(\tilde\omega_1\))", R"(\(\tilde\omega_2\))", R"(\(\tilde\omega_3\))", R"(\(\Delta\phi\) / rad)",
                R"(\(2TP/L\) / rad)", R"(\(S\))"},
               table, 4);
}
//! [phases]

//! [area]
TEST_CASE("area: The solid angle of a closed curve by a sum over equal steps") {
  //! [area in brief]
  const auto theta = [](double xi) { return 0.7 + 0.2 * std::cos(2 * xi); };
  const auto area = [&](int steps) {
    double S = 0;
    for (int i = 0; i < steps; ++i) S += (1 - std::cos(theta(2 * pi * i / steps))) * 2 * pi / steps;
    return S;
  };
  const Vector3d S(area(4), area(8), area(16));
  //! [area in brief]

  CHECK(agrees(area(16), area(1000), 1e-9));
  result(R"((S_4,\ S_8,\ S_{16}))", S, "", "with 4, 8 and 16 steps", 8);
}
//! [area]

TEST_CASE("The solid angle of L from the energy alone") {
  const Vector3d I(1.2, 2, 2.7), omega0(0.4, -0.9, 0.6);  // round axis 3
  const double L2 = I.cwiseProduct(omega0).squaredNorm();
  const double level = I.dot(omega0.cwiseAbs2()) / L2;  // 2T/L²
  const int steps = 200;
  double S = 0;
  for (int i = 0; i < steps; ++i) {
    const double cos2 = std::pow(std::cos(2 * pi * i / steps), 2);
    const double b = cos2 / I[0] + (1 - cos2) / I[1];
    const double sin2 = (level - 1 / I[2]) / (b - 1 / I[2]);
    S += (1 - std::sqrt(1 - sin2)) * 2 * pi / steps;
  }
  CHECK(agrees(S, geometric_phase(I, omega0), 1e-12));
  CHECK(agrees(S, 1.27299602291, 1e-11));
}

TEST_CASE("A symmetric top: the solid angle is that of a cone, and the turn is L/I₁ times the period") {
  const double I1 = 1, I3 = 1.8;
  const Vector3d I(I1, I1, I3), omega0(0.4, 0, 2);
  const Vector3d L = L_of(I, omega0);
  const double P = tumbling_period(I, omega0), S = 2 * pi * (1 - L[2] / L.norm());
  CHECK(agrees(twice_T(I, omega0) * P / L.norm() + 2 * pi - S, space_precession_rate(I1, I3, omega0) * P, 1e-13));
  // Nearly symmetric bodies come close to it.
  const Vector3d nearly(1, 1.1, 1.8), nearer(1, 1.0999, 1.8);
  CHECK(std::abs(geometric_phase(nearly, {0.1, 0, 0.8}) - geometric_phase(nearer, {0.1, 0, 0.8})) < 1e-4);
}

// ---- the racket

//! [growth]
TEST_CASE("growth: Three numbers that make it half a turn") {
  //! [growth in brief]
  const Vector3d I(1.21e-3, 16.38e-3, 17.48e-3);  // kg m²: a racket
  const double mu = growth_rate(I, 1);            // per radian of the handle
  const double growth = std::exp(2 * pi * mu);
  const double passage = 2 / mu * std::log(1 / std::tan(15 * degree));
  double enough = 0;  // degrees off axis 2, towards the normal
  while (twist_of_throw(I, 0, enough) < 90) enough += 0.01;
  //! [growth in brief]

  // On the separatrix χ goes from 30° to 150° while the handle goes that far.
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const auto slowness = [&](double chi) { return 1 / (mu * std::sin(chi)); };
  CHECK(agrees(quadrature.integrate(slowness, 30 * degree, 150 * degree), passage, 1e-12));
  CHECK(agrees(std::log(1000) / mu, 7.777, 1e-3));

  result(R"(\mu)", mu, "", "of the racket", 4);
  result(R"(e^{2\pi\mu})", growth, "", "the growth of a disturbance in one round of the handle", 3);
  result(R"(\Delta\phi_1)", passage / degree, "°", R"(of the handle, for \(\chi\) from 30° to 150°)", 3);
  result(R"(\delta_{\min})", enough, "°", "off axis 2, towards the normal, are enough for the other face", 2);
}
//! [growth]

//! [handle]
TEST_CASE("handle: The twist of a racket while its handle goes round once") {
  Eigen::MatrixXd table(7, 3);
  //! [handle in brief]
  const Vector3d I(1.21e-3, 16.38e-3, 17.48e-3);  // kg m²: a racket
  int row = 0;
  for (const double off : {0.1, 1.0, 2.0, 5.0, 10.0, 15.0, 20.0}) {  // degrees
    const double to_handle = twist_of_throw(I, off, 0);
    const double to_normal = twist_of_throw(I, 0, off);
    table.row(row++) << off, to_handle, to_normal;
  }
  //! [handle in brief]

  // How fast it is thrown does not count, and a throw turned by half a turn about axis 2 twists the other way.
  const Vector3d omega0(0.5, 10, -0.7);
  CHECK(agrees(racket_twist(I, 3 * omega0), racket_twist(I, omega0), 1e-9));
  CHECK(agrees(racket_twist(I, {0.5, 10, 0.7}), racket_twist(I, {-0.5, 10, -0.7}) * -1, 1e-9));
  // Never past the other rest: less than a full turn, and for throws that are not very good more than a quarter.
  for (int i = 2; i < row; ++i) CHECK((table(i, 2) > 90 && table(i, 2) < 270));

  result_table(
      {R"(\(\vec\omega\) off axis 2 / °)", "twist / ° (off towards the handle)", "twist / ° (off towards the normal)"},
      table, 3);
}
//! [handle]

//! [odds]
TEST_CASE("odds: How often a careless throw comes back with the other face up") {
  Eigen::MatrixXd table(3, 3);
  //! [odds in brief]
  const Vector3d I(1.21e-3, 16.38e-3, 17.48e-3);  // kg m²
  int row = 0;
  for (const double care : {3.0, 10.0, 20.0}) {  // degrees off axis 2, at most
    int throws = 0, half_turns = 0, other_face = 0;
    for (int i = -20; i <= 20; ++i) {
      for (int j = -20; j <= 20; ++j) {
        if (i * i + j * j > 400) continue;
        const double twist = twist_of_throw(I, care * i / 20, care * j / 20);
        ++throws;
        if (std::abs(twist - 180) < 30) ++half_turns;
        if (std::cos(twist * degree) < 0) ++other_face;
      }
    }
    const double percent = 100.0 / throws;
    table.row(row++) << care, half_turns * percent, other_face * percent;
  }
  //! [odds in brief]

  for (int i = 0; i < 3; ++i) CHECK(table(i, 2) > 75);
  result_table({R"(\(\vec\omega\) off axis 2, at most / °)", "half a turn, ± 30° / %", "other face up / %"}, table, 3);
}
//! [odds]
