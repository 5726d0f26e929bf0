// Worked examples of lecture 06. Each case is a paragraph of the notes that computes its own numbers.
#include "lectures/support/agrees.hpp"
#include "lectures/support/printed.hpp"

#include <rigid/free_tops.hpp>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace rigid;
using workbook::agrees;
using workbook::Printed;
using workbook::row;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

//! [second route]
// Angular velocity in body components, and the attitude A (V_inertial = A V_body), at one time.
struct Motion {
  Vector3d omega;
  Matrix3d A;
};

// The second route of this lecture: Euler's equations (lecture 05) without torque, and dA/dt = A [ω]× beside them,
// integrated numerically from A = 1. No formula for tops enters here.
Motion integrated(const Vector3d& I, const Vector3d& omega0, double t) {
  using State = std::vector<double>;  // ω, then the rows of A
  State state{omega0[0], omega0[1], omega0[2], 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto system = [&I](const State& now, State& rate, double) {
    const Vector3d omega(now[0], now[1], now[2]);
    const Vector3d L = I.cwiseProduct(omega);
    const Vector3d omega_rate = L.cross(omega).cwiseQuotient(I);
    std::copy(omega_rate.begin(), omega_rate.end(), rate.begin());
    for (std::size_t i = 3; i < 12; i += 3) {
      // A row of A [ω]× is the cross product of the row of A with ω.
      const Vector3d turned = Vector3d(now[i], now[i + 1], now[i + 2]).cross(omega);
      std::copy(turned.begin(), turned.end(), &rate[i]);
    }
  };
  namespace odeint = boost::numeric::odeint;
  const auto stepper = odeint::make_controlled(1e-17, 1e-14, odeint::runge_kutta_fehlberg78<State>());
  if (t != 0) odeint::integrate_adaptive(stepper, system, state, 0.0, t, t / 100);
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> A(&state[3]);
  return {{state[0], state[1], state[2]}, A};
}

// The flattened top of this lecture: I₁ = I₂ = 1, I₃ = 1.8 kg m², A = 0.4 rad/s, φ = 0.3, ω₃ = 2 rad/s.
struct Top {
  double I1 = 1, I3 = 1.8;
  double amplitude = 0.4, phase = 0.3, omega3 = 2;
  Vector3d I{I1, I1, I3};
  Vector3d omega0{amplitude * std::cos(phase), amplitude* std::sin(phase), omega3};
};

// The flat body of this lecture: the third moment is the sum of the other two.
const Vector3d flat_body(1, 2, 3);
//! [second route]

/// The first two times after 0 at which the component of ω vanishes, by integration.
std::array<double, 2> zero_crossings(const Vector3d& I, const Vector3d& omega0, int component) {
  const double step = 0.25;
  std::array<double, 2> found{};
  std::size_t count = 0;
  Vector3d omega = omega0;
  for (int i = 0; count < 2; ++i) {
    const Vector3d next = integrated(I, omega, step).omega;
    if (omega[component] != 0 && omega[component] * next[component] < 0) {
      const auto at = [&](double t) { return integrated(I, omega, t).omega[component]; };
      std::uintmax_t rounds = 60;
      const auto [low, high] =
          boost::math::tools::toms748_solve(at, 0.0, step, boost::math::tools::eps_tolerance<double>(50), rounds);
      found[count++] = i * step + (low + high) / 2;
    }
    omega = next;
  }
  return found;
}

double twice_energy(const Vector3d& I, const Vector3d& omega) { return I.dot(omega.cwiseAbs2()); }
double momentum_squared(const Vector3d& I, const Vector3d& omega) { return I.cwiseProduct(omega).squaredNorm(); }

}  // namespace

// ---- the symmetric top ---------------------------------------------------------------------------------------------

//! [symmetric top]
TEST_CASE("Seen from a symmetric top, ω runs round the symmetry axis at the steady rate Ω") {
  const Top top;

  const double rate = body_precession_rate(top.I1, top.I3, top.omega3);  // Ω
  CHECK(agrees(rate, 2 * (1.8 - 1) / 1));

  const double t = 0.7;
  const Vector3d omega = symmetric_top(top.I1, top.I3, top.omega0, t);
  CHECK(agrees(omega, Vector3d(0.4 * std::cos(rate * t + 0.3), 0.4 * std::sin(rate * t + 0.3), 2), 1e-14));

  // Euler's equations, integrated step by step, know nothing of Ω, and agree.
  const Vector3d by_integration = integrated(top.I, top.omega0, t).omega;
  CHECK(agrees(omega, by_integration, 1e-12));
  CHECK(agrees(omega, Vector3d(0.06009018796, 0.3954607051, 2), 1e-9));

  Printed page("symmetric top");
  page.line("Ω = {:.10g} rad/s, once round in {:.6f} s", rate, 2 * pi / rate);
  page.line("ω(0.7 s) by the formula:     {} rad/s", row(omega));
  page.line("ω(0.7 s) by integration:     {} rad/s", row(by_integration));
}
//! [symmetric top]

//! [energy and momentum]
TEST_CASE("The wobble carries energy and momentum, and the body sees L turn with ω") {
  const Top top;
  const double T = 0.5 * top.I1 * top.amplitude * top.amplitude + 0.5 * top.I3 * top.omega3 * top.omega3;
  const double rate = body_precession_rate(top.I1, top.I3, top.omega3);

  for (const double t : {0.0, 0.7, 5.0, -3.0}) {
    const Vector3d omega = symmetric_top(top.I1, top.I3, top.omega0, t);
    const Vector3d L = top.I.cwiseProduct(omega);
    const double angle = rate * t + top.phase;
    CHECK(agrees(L,
                 Vector3d(top.I1 * top.amplitude * std::cos(angle), top.I1 * top.amplitude * std::sin(angle),
                          top.I3 * top.omega3),
                 1e-14));
    CHECK(agrees(0.5 * L.dot(omega), T, 1e-14));
    // The components of L change, its length does not; and on axes at rest even the components stay.
    CHECK(agrees(L.norm(), top.I.cwiseProduct(top.omega0).norm(), 1e-14));
    CHECK(agrees(integrated(top.I, top.omega0, t).A * L, top.I.cwiseProduct(top.omega0), 1e-12));
  }

  Printed page("energy and momentum");
  page.line("T = ½ I₁A² + ½ I₃ω₃² = {:.4g} + {:.4g} = {:.6g} J", 0.5 * top.I1 * 0.16, 0.5 * top.I3 * 4, T);
  page.line("L in the body at 0 s:   {} kg m²/s", row(top.I.cwiseProduct(top.omega0), "{:.6f}"));
  page.line("L in the body at 0.7 s: {} kg m²/s",
            row(top.I.cwiseProduct(symmetric_top(1, 1.8, top.omega0, 0.7)), "{:.6f}"));
  page.line("|L| at both:            {:.9f} kg m²/s", top.I.cwiseProduct(top.omega0).norm());
}
//! [energy and momentum]

//! [two rates]
TEST_CASE("In the inertial frame the axis runs round L at the rate L/I₁, and the body turns back under it") {
  const Top top;
  const Vector3d L = top.I.cwiseProduct(top.omega0);
  const double precession = space_precession_rate(top.I1, top.I3, top.omega0);
  const double own_spin = -body_precession_rate(top.I1, top.I3, top.omega3);

  // ω is the sum of a rotation about the fixed L and one about the body's own axis.
  CHECK(agrees(precession * L.normalized() + own_spin * Vector3d::UnitZ(), top.omega0, 1e-14));
  CHECK(agrees(precession, 3.622154055255, 1e-12));

  // The integrated attitude shows the same: after a time t the axis has run through the angle (L/I₁)t about L.
  const double t = 0.7;
  const Vector3d axis_at_start = Vector3d::UnitZ();
  const Vector3d axis = integrated(top.I, top.omega0, t).A.col(2);
  const Vector3d across_at_start = L.cross(axis_at_start).normalized();
  const Vector3d across = L.cross(axis).normalized();
  const double angle = std::atan2(L.normalized().dot(across_at_start.cross(across)), across_at_start.dot(across));
  CHECK(agrees(angle, precession * t, 1e-11));

  const double tilt = std::acos(L.normalized()[2]);              // between L and the axis
  const double opening = std::acos(top.omega0.normalized()[2]);  // between ω and the axis
  CHECK(agrees(tilt / degree, 6.340191746, 1e-9));
  CHECK(agrees(opening / degree, 11.309932474, 1e-9));

  Printed page("two rates");
  page.line("about L:          L/I₁ = {:.9f} rad/s", precession);
  page.line("about its axis:   −Ω   = {:.9f} rad/s", own_spin);
  page.line("angle L, axis = {:.4f}°; angle ω, axis = {:.4f}°; angle ω, L = {:.4f}°", tilt / degree, opening / degree,
            (opening - tilt) / degree);
}
//! [two rates]

//! [rolling]
TEST_CASE("The body cone rolls on the space cone without slipping") {
  const Top top;
  // A point of the body on the axis of rotation is at rest for the moment. Follow the point of the body that lies on ω
  // at t = 0, and measure how fast it moves at that moment and a quarter of a second later.
  const auto speed = [&](double t) {
    const Motion motion = integrated(top.I, top.omega0, t);
    const Vector3d point = top.omega0.normalized();
    return motion.omega.cross(point).norm();  // |ω × r|, the same on any axes
  };
  CHECK(agrees(speed(0), 0, 1e-14, 1));
  CHECK(speed(0.25) > 0.1);

  // Rolling: the arc laid down on the rim of the space cone equals the arc on the rim of the body cone. At distance 1
  // along ω the radii are the sines of the opening angles.
  const Vector3d L = top.I.cwiseProduct(top.omega0);
  const double radius_body = top.omega0.normalized().cross(Vector3d::UnitZ()).norm();
  const double radius_space = top.omega0.normalized().cross(L.normalized()).norm();
  const double arc_body = body_precession_rate(top.I1, top.I3, top.omega3) * radius_body;
  const double arc_space = space_precession_rate(top.I1, top.I3, top.omega0) * radius_space;
  CHECK(agrees(arc_body, arc_space, 1e-14));

  Printed page("rolling");
  page.line("rim of the body cone:  radius {:.6f}, swept at {:.6f} rad/s: {:.6f} per second", radius_body, 1.6,
            arc_body);
  page.line("rim of the space cone: radius {:.6f}, swept at {:.6f} rad/s: {:.6f} per second", radius_space,
            space_precession_rate(top.I1, top.I3, top.omega0), arc_space);
}
//! [rolling]

//! [attitude in one line]
TEST_CASE("The attitude of a symmetric top in one line") {
  const Top top;
  const double t = 4.0;

  const Vector3d L = top.I.cwiseProduct(top.omega0);
  const Eigen::AngleAxisd about_momentum(L.norm() / top.I1 * t, L.normalized());
  const Eigen::AngleAxisd about_own_axis(-body_precession_rate(top.I1, top.I3, top.omega3) * t, Vector3d::UnitZ());
  const Matrix3d A = (about_momentum * about_own_axis).toRotationMatrix();

  const Matrix3d by_integration = integrated(top.I, top.omega0, t).A;
  CHECK(agrees(A, by_integration, 1e-12));
  CHECK(agrees(A * symmetric_top(top.I1, top.I3, top.omega0, t),
               by_integration * integrated(top.I, top.omega0, t).omega, 1e-12));

  Printed page("attitude in one line");
  page.line("A(4 s) in one line =");
  page.matrix(A, "{:12.9f}");
  page.line("A(4 s) integrated =");
  page.matrix(by_integration, "{:12.9f}");
}
//! [attitude in one line]

//! [shapes]
TEST_CASE("From plate to needle: what shapes allow") {
  // A uniform cylinder of mass M, radius r and height h has I₃ = Mr²/2 and I₁ = M(3r² + h²)/12.
  Printed page("shapes");
  page.line("{:>6}  {:>8}  {:>8}", "h/r", "I₃/I₁", "Ω/ω₃");
  for (const double height : {0.0, 0.5, 1.0, std::sqrt(3.0), 3.0, 10.0, 1000.0}) {
    const double I3 = 0.5, I1 = (3 + height * height) / 12;
    CHECK(I3 <= 2 * I1);  // the triangle inequality I₃ ≤ I₁ + I₂
    const double rate = body_precession_rate(I1, I3, 1.0);
    CHECK(std::abs(rate) <= 1);  // ω never runs round the axis faster than the body spins
    page.line("{:6.3f}  {:8.5f}  {:8.5f}", height, I3 / I1, rate == 0 ? 0.0 : rate);
  }
  CHECK(agrees(body_precession_rate(0.25, 0.5, 1.0), 1));                    // the plate
  CHECK(agrees(body_precession_rate(0.5, 0.5, 1.0), 0, 1e-14, 1));           // as round as a sphere: h = √3 r
  CHECK(agrees(body_precession_rate(1e6 / 12 + 0.25, 0.5, 1.0), -1, 1e-5));  // the needle
}
//! [shapes]

//! [V27]
TEST_CASE("V27 Oblate top: the tests of an ephemeris program") {
  // Principia's test of rigid bodies, after a lecture at ETH: I = (3, 3, 9), L at time 0 = (0, 5, 7), in the body
  // L(t) = (5 sin Ωt, 5 cos Ωt, 7) with their Ω = L_z (I₁ − I₃)/(I₁I₃), which is −Ω of the slides.
  // No body has these moments (9 > 3 + 3); the equations do not mind.
  const Vector3d I(3, 3, 9), L0(0, 5, 7);
  const Vector3d omega0 = L0.cwiseQuotient(I);
  const double their_rate = 7.0 * (3 - 9) / (3 * 9);

  CHECK(agrees(-body_precession_rate(3, 9, omega0[2]), their_rate, 1e-14));
  for (const double t : {0.0, 0.5, 1.0, 2.0, -1.0}) {
    const Vector3d L = I.cwiseProduct(symmetric_top(3, 9, omega0, t));
    CHECK(agrees(L, Vector3d(5 * std::sin(their_rate * t), 5 * std::cos(their_rate * t), 7), 1e-13));
  }

  Printed page("V27");
  page.line("V27 | -1.5556 | {:.6f} | 1e-13", -body_precession_rate(3, 9, omega0[2]));
}
//! [V27]

//! [thrown plate]
TEST_CASE("V35 Thrown plate: it wobbles nearly twice as fast as it spins") {
  // For a plate I₃ = 2I₁. An observer sees the wobble, the rate L/I₁, and the turning of the plate's pattern, which for
  // a small tilt is the sum of both rates about nearly the same direction.
  const auto ratio = [](double tilt) {
    const double I1 = 1, I3 = 2, omega3 = 1;
    // L = (I₁ω₁, 0, I₃ω₃) makes the angle `tilt` with the axis.
    const Vector3d omega(I3 / I1 * omega3 * std::tan(tilt), 0, omega3);
    const double wobble = space_precession_rate(I1, I3, omega);
    return wobble / (wobble - body_precession_rate(I1, I3, omega3));
  };

  CHECK(agrees(ratio(10 * degree), 1.97007, 1e-5));  // S. Tuleja and others, on Feynman's wobbling plate
  CHECK(agrees(ratio(10 * degree), 2 / (2 - std::cos(10 * degree)), 1e-14));
  CHECK(agrees(ratio(1e-8), 2, 1e-14));

  Printed page("thrown plate");
  for (const double tilt : {1.0, 5.0, 10.0, 20.0})
    page.line("tilt {:4.0f}°: wobble / spin = {:.5f}", tilt, ratio(tilt * degree));
  Printed table("V35");
  table.line("V35 | 1.97007 | {:.5f} | 1e-5", ratio(10 * degree));
}
//! [thrown plate]

//! [Earth]
TEST_CASE("V36 Earth: Euler's ten months") {
  // The precession of the equinoxes gives H = (I₃ − I₁)/I₃ = 0.0032737949. Once round in the body takes 2π/Ω.
  const double H = 0.0032737949;
  const double I3 = 1, I1 = 1 - H;  // only the ratio matters
  const double omega3 = 2 * pi;     // one turn per sidereal day
  const double sidereal_days = 2 * pi / body_precession_rate(I1, I3, omega3);
  const double solar_days = sidereal_days * 86164.0905 / 86400;

  CHECK(agrees(sidereal_days, (1 - H) / H, 1e-12));
  CHECK(agrees(sidereal_days, 304.456, 2e-6));
  CHECK(agrees(solar_days, 303.625, 2e-6));
  CHECK(agrees(sidereal_days, 305, 0.005));  // the published round number for a rigid Earth

  Printed page("Earth");
  page.line("a rigid Earth:       {:.3f} sidereal days = {:.3f} solar days", sidereal_days, solar_days);
  const double observed = 435;  // S. C. Chandler, 1891, in solar days
  CHECK(observed > 1.4 * solar_days);
  page.line("observed (Chandler): about {} days, {:.2f} times as long", observed, observed / solar_days);
  Printed table("V36");
  table.line("V36 | 305 | {:.3f} | 0.5 %", sidereal_days);
}
//! [Earth]

// ---- the asymmetric top near an axis
// ---------------------------------------------------------------------------------

//! [two linear rates]
TEST_CASE("Near axis 3, Euler's first two equations become linear") {
  const Vector3d I(2, 3, 1);
  const double omega3 = 5;
  const Vector2d rates = linearized_rates(I, omega3);
  CHECK(agrees(rates, Vector2d(-5, -5.0 / 3), 1e-14));

  // Read the two coefficients off Euler's equations themselves. These are quadratic, so a central difference is exact.
  const auto omega_rate = [&](const Vector3d& omega) -> Vector3d {
    return Vector3d(I.cwiseProduct(omega)).cross(omega).cwiseQuotient(I);
  };
  const Vector3d along_2 = (omega_rate({0, 1, omega3}) - omega_rate({0, -1, omega3})) / 2;
  const Vector3d along_1 = (omega_rate({1, 0, omega3}) - omega_rate({-1, 0, omega3})) / 2;
  CHECK(agrees(-along_2[0], rates[0], 1e-14));
  CHECK(agrees(along_1[1], rates[1], 1e-14));

  Printed page("two linear rates");
  page.line("Ω₁ = {:.10g} rad/s, Ω₂ = {:.10g} rad/s, both negative", rates[0], rates[1]);
  page.line("√(Ω₁Ω₂) = {:.10g} rad/s", std::sqrt(rates.prod()));
}
//! [two linear rates]

//! [slip]
TEST_CASE("A slip on the slides: with both rates negative, the second component has the other sign") {
  const Vector3d I(2, 3, 1);
  const double omega3 = 5, amplitude = 1e-5, t = 0.2;
  const Vector2d rates = linearized_rates(I, omega3);
  const double angle = std::sqrt(rates.prod()) * t;

  const double by_the_slides = amplitude * std::sqrt(rates[1] / rates[0]) * std::sin(angle);
  const double by_integration = integrated(I, {amplitude, 0, omega3}, t).omega[1];
  const double corrected = linearized_top(I, omega3, amplitude, 0, t)[1];

  // The judge is Euler's equations: at t = 0 they say dω₂/dt = Ω₂ω₁ < 0, so ω₂ must become negative.
  CHECK(agrees(by_integration, -3.15121e-6, 1e-5));
  CHECK(agrees(by_the_slides, -by_integration, 1e-9));  // the right size and the wrong sign
  CHECK(agrees(corrected, by_integration, 1e-9));

  // With the spin turned round, Ω₁ and Ω₂ are positive, and there the slides are right.
  const Vector2d positive = linearized_rates(I, -omega3);
  const double right = amplitude * std::sqrt(positive[1] / positive[0]) * std::sin(std::sqrt(positive.prod()) * t);
  CHECK(agrees(right, integrated(I, {amplitude, 0, -omega3}, t).omega[1], 1e-9));

  Printed page("slip");
  page.line("ω₂ integrated:             {:+.5e} rad/s", by_integration);
  page.line("ω₂ as printed on slides:   {:+.5e} rad/s", by_the_slides);
  page.line("ω₂ with sgn(Ω₁):           {:+.5e} rad/s", corrected);
}
//! [slip]

//! [worked wobble]
TEST_CASE("A small wobble with a phase: the exercise's numbers, twice") {
  const Vector3d I(2, 3, 1);
  const Vector2d omega = linearized_top(I, 5, 0.01, 0.3, 0.2);
  CHECK(agrees(omega, Vector2d(0.006391911556, -0.004440100099), 1e-9));

  // The linear equations themselves, integrated from the wobble's own start.
  const Vector2d rates = linearized_rates(I, 5);
  using State = std::vector<double>;
  State state{linearized_top(I, 5, 0.01, 0.3, 0)[0], linearized_top(I, 5, 0.01, 0.3, 0)[1]};
  const auto system = [&](const State& now, State& rate, double) { rate = {-rates[0] * now[1], rates[1] * now[0]}; };
  namespace odeint = boost::numeric::odeint;
  odeint::integrate_adaptive(odeint::make_controlled(1e-17, 1e-14, odeint::runge_kutta_fehlberg78<State>()), system,
                             state, 0.0, 0.2, 0.01);
  CHECK(agrees(omega, Vector2d(state[0], state[1]), 1e-12));
  CHECK(agrees(linearized_top(I, 5, 0.01, 0.3, 0)[0], 0.01 * std::cos(0.3), 1e-14));

  Printed page("worked wobble");
  page.line("(ω₁, ω₂) at 0 s:   {} rad/s", row(linearized_top(I, 5, 0.01, 0.3, 0)));
  page.line("(ω₁, ω₂) at 0.2 s: {} rad/s", row(omega));
}
//! [worked wobble]

//! [how small]
TEST_CASE("ω₃ is not constant, only nearly: its change is of second order in the wobble") {
  const Vector3d I(2, 3, 1);
  const double omega3 = 5;

  // A quarter of a wobble later all of ω₁ has gone into ω₂, and ω₃ has changed the most.
  const double quarter = pi / 2 / std::sqrt(linearized_rates(I, omega3).prod());
  std::vector<double> changes, errors;
  Printed page("how small");
  page.line("{:>6}  {:>15}  {:>22}", "A", "change of ω₃", "error of linear ω₁, ω₂");
  for (const double amplitude : {0.4, 0.2, 0.1, 0.05}) {
    const Vector3d omega = integrated(I, {amplitude, 0, omega3}, quarter).omega;
    changes.push_back(std::abs(omega[2] - omega3));
    errors.push_back((linearized_top(I, omega3, amplitude, 0, quarter) - omega.head<2>()).norm());
    page.line("{:6.3f}  {:15.3e}  {:22.3e}", amplitude, changes.back(), errors.back());
  }
  // Half the wobble: a quarter of the change of ω₃, an eighth of the error in the small components.
  for (std::size_t i = 1; i < changes.size(); ++i) {
    CHECK(agrees(changes[i - 1] / changes[i], 4, 0.02));
    CHECK(agrees(errors[i - 1] / errors[i], 8, 0.04));
  }
}
//! [how small]

//! [three axes]
TEST_CASE("Stable about the largest and the smallest moment, unstable about the one between") {
  const Vector3d I(2, 3, 1);
  Printed page("three axes");
  page.line("{:>4}  {:>6}  {:>9}  {:>9}  {:>9}  {}", "axis", "moment", "Ω₁", "Ω₂", "Ω₁Ω₂", "stability");
  for (int axis = 0; axis < 3; ++axis) {
    // Name the axes anew, in turn, so that the one in question becomes axis 3.
    const Vector3d renamed(I[(axis + 1) % 3], I[(axis + 2) % 3], I[axis]);
    const Vector2d rates = linearized_rates(renamed, 1);

    // Second route: disturb the spin a little and see how far it strays.
    Vector3d omega0 = Vector3d::Constant(1e-6);
    omega0[axis] = 1;
    double strayed = 0;
    for (double t = 0; t <= 20; t += 0.5) {
      Vector3d omega = integrated(I, omega0, t).omega;
      omega[axis] = 0;
      strayed = std::max(strayed, omega.norm());
    }

    CHECK(axis_stability(I, axis) == (rates.prod() > 0 ? 1 : -1));
    CHECK((axis_stability(I, axis) == 1) == (strayed < 1e-5));
    page.line("{:4}  {:6}  {:9.5f}  {:9.5f}  {:9.5f}  {:+d}", axis, I[axis], rates[0], rates[1], rates.prod(),
              axis_stability(I, axis));
  }
  CHECK(axis_stability(I, 0) == -1);
  CHECK(axis_stability(I, 1) == 1);
  CHECK(axis_stability(I, 2) == 1);
}
//! [three axes]

//! [neutral]
TEST_CASE("With an equal partner an axis is neutral: a disturbance grows, but only in proportion to time") {
  // A symmetric top spins about axis 1, across its symmetry axis, with a trace of ω₃.
  const Vector3d omega0(1, 0, 1e-4);
  CHECK(axis_stability({1, 1, 1.8}, 0) == 0);
  CHECK(axis_stability({1, 1, 1.8}, 2) == 1);

  Printed page("neutral");
  for (const double t : {10.0, 20.0, 40.0}) {
    const double omega2 = integrated({1, 1, 1.8}, omega0, t).omega[1];
    CHECK(agrees(omega2, std::sin(0.8e-4 * t), 1e-10));
    CHECK(agrees(omega2, 0.8e-4 * t, 1e-5));
    page.line("after {:2.0f} s: ω₂ = {:.4e} rad/s", t, omega2);
  }
}
//! [neutral]

//! [amplitude and energy]
TEST_CASE("How much a wobble weighs: amplitude from energy and momentum") {
  Printed page("amplitude and energy");
  page.line("{:>10}  {:>16}  {:>16}  {:>20}", "I", "A put in", "A from T and L", "T − L²/2I₃ (J)");
  for (const Vector3d& I : {Vector3d(1, 2, 3), Vector3d(2, 3, 1)}) {
    const double amplitude = 0.3;
    const Vector3d omega0(amplitude, 0, 2);  // at this moment all of the wobble is in ω₁
    // Some other moment of the same motion, at which nobody can see A.
    const Vector3d omega = integrated(I, omega0, 0.55).omega;
    CHECK(std::abs(omega[0]) < 0.9 * amplitude);

    const double twice_T = twice_energy(I, omega), L_squared = momentum_squared(I, omega);
    const double from_invariants = std::sqrt((twice_T * I[2] - L_squared) / (I[0] * (I[2] - I[0])));
    const double cost = twice_T / 2 - L_squared / (2 * I[2]);

    CHECK(agrees(from_invariants, amplitude, 1e-11));
    CHECK(agrees(cost, I[0] * (I[2] - I[0]) / (2 * I[2]) * amplitude * amplitude, 1e-11));
    CHECK((cost > 0) == (I[2] == I.maxCoeff()));
    page.line("{:>10}  {:16.12f}  {:16.12f}  {:20.6f}", row(I), amplitude, from_invariants, cost);
  }
}
//! [amplitude and energy]

//! [growth]
TEST_CASE("About the intermediate axis a disturbance grows as exp(σt)") {
  const double omega2 = 1.5;
  const double sigma = growth_rate(flat_body, omega2);
  CHECK(agrees(sigma, 0.8660254038, 1e-9));
  CHECK(agrees(sigma, omega2 / std::sqrt(3.0), 1e-14));  // (1·1)/(1·3) under the root

  // Start from a disturbance of one part in 10⁸. After a while only its growing part is left.
  const Vector3d omega0(1e-8, omega2, 0);
  const double earlier = integrated(flat_body, omega0, 8).omega[0];
  const double later = integrated(flat_body, omega0, 12).omega[0];
  const double by_integration = std::log(later / earlier) / 4;
  CHECK(agrees(by_integration, sigma, 1e-5));
  CHECK(agrees(growth_rate(flat_body, -omega2), sigma, 1e-14));  // the sense of the spin is no matter

  Printed page("growth");
  page.line("σ by the formula:   {:.7f} /s", sigma);
  page.line("σ by integration:   {:.5f} /s", by_integration);
  page.line("in one turn, 2π/ω₂ = {:.4f} s, a disturbance grows {:.1f} times", 2 * pi / omega2,
            std::exp(sigma * 2 * pi / omega2));
}
//! [growth]

//! [fastest growth]
TEST_CASE("Of all bodies with the same I₂/I₃ the flat one is the most unstable") {
  // For the ratio I₂/I₃ = x the rate is largest when I₁ is as small as a real body allows: I₁ = I₃ − I₂.
  // Then σ/ω₂ = √(2x − 1), which stays below 1.
  for (const double x : {0.55, 0.7, 0.9, 0.99}) {
    const double flat = growth_rate({1 - x, x, 1}, 1);
    CHECK(agrees(flat, std::sqrt(2 * x - 1), 1e-13));
    CHECK(flat < 1);
    for (const double more : {1.05, 1.2}) CHECK(growth_rate({std::min(x, more * (1 - x)), x, 1}, 1) < flat);
  }
  CHECK(agrees(growth_rate({1, 1, 2}, 1), 0, 1e-14, 1));  // two equal moments: nothing grows
  CHECK(agrees(growth_rate({1, 2, 2}, 1), 0, 1e-14, 1));

  Printed page("fastest growth");
  for (const double x : {0.55, 0.7, 0.9, 0.99})
    page.line("I₂/I₃ = {:.2f}: σ/ω₂ at most {:.5f}", x, growth_rate({1 - x, x, 1}, 1));
}
//! [fastest growth]

// ---- the asymmetric top at any amplitude
// -----------------------------------------------------------------------------

//! [two kinds of motion]
TEST_CASE("ω circles axis 3 or axis 1, and L² against 2T·I₂ decides which") {
  Printed page("two kinds of motion");
  for (const Vector3d& omega0 : {Vector3d(0.1, 1, 0.1), Vector3d(1, 0.5, 0.25)}) {
    const double excess = momentum_squared(flat_body, omega0) - twice_energy(flat_body, omega0) * flat_body[1];
    const int circled = excess > 0 ? 2 : 0;

    // Follow the motion for a full period: the component along the circled axis never changes its sign, the others do.
    Eigen::Vector3i changes = Eigen::Vector3i::Zero();
    Vector3d before = omega0;
    const int steps = 100;
    const double step = tumbling_period(flat_body, omega0) / steps;
    for (int i = 0; i < steps; ++i) {
      const Vector3d now = integrated(flat_body, before, step).omega;
      changes += (now.cwiseProduct(before).array() < 0).matrix().cast<int>();
      before = now;
      // All the while ω stays on two ellipsoids: one of energy, one of angular momentum.
      CHECK(agrees(twice_energy(flat_body, now), twice_energy(flat_body, omega0), 1e-11));
      CHECK(agrees(momentum_squared(flat_body, now), momentum_squared(flat_body, omega0), 1e-11));
    }
    CHECK(changes[circled] == 0);
    CHECK(changes[1] == 2);
    CHECK(changes[2 - circled] == 2);
    page.line("ω(0) = {}: L² − 2T·I₂ = {:+.4g}, so ω circles axis {}; changes of sign: {}, {}, {}", row(omega0), excess,
              circled + 1, changes[0], changes[1], changes[2]);
  }
}
//! [two kinds of motion]

//! [exact period]
TEST_CASE("The period in closed form, and by watching the integrated motion") {
  Printed page("exact period");
  for (const Vector3d& omega0 : {Vector3d(0.1, 1, 0.1), Vector3d(1, 0.5, 0.25)}) {
    const double period = tumbling_period(flat_body, omega0);

    // ω₂ passes zero twice in a period, going down and going up, half a period apart.
    const auto [first, second] = zero_crossings(flat_body, omega0, 1);
    CHECK(agrees(2 * (second - first), period, 1e-10));
    // After a full period, and not after half of one, ω is what it was.
    CHECK(agrees(integrated(flat_body, omega0, period).omega, omega0, 1e-10));
    CHECK((integrated(flat_body, omega0, period / 2).omega - omega0).norm() > 0.1);

    page.line("ω(0) = {}: period {:.9f} s in closed form, {:.9f} s watched", row(omega0), period, 2 * (second - first));
  }
  CHECK(agrees(tumbling_period(flat_body, {0.1, 1, 0.1}), 22.996262944122, 1e-12));
  CHECK(agrees(tumbling_period(flat_body, {1, 0.5, 0.25}), 10.809345300803, 1e-12));
}
//! [exact period]

//! [modulus]
TEST_CASE("Modulus or parameter: two letters for one integral, and a wrong answer that looks right") {
  // The motion with ω(0) = (1, 0.5, 0.25) circles axis 1. With the names 1 and 3 exchanged:
  const Vector3d omega0(1, 0.5, 0.25);
  const double twice_T = twice_energy(flat_body, omega0), L_squared = momentum_squared(flat_body, omega0);
  const double steady = (L_squared - twice_T * 3) * (1 - 2);
  const double m = (twice_T * 1 - L_squared) * (2 - 3) / steady;
  const double lambda = std::sqrt(steady / (1 * 2 * 3));
  CHECK(agrees(m, 0.35, 1e-14));

  // The integral from its definition; over a full turn of a periodic integrand equal steps are all one needs.
  const auto by_definition = [](double parameter) {
    double sum = 0;
    const int nodes = 400;
    for (int i = 0; i < nodes; ++i) sum += 1 / std::sqrt(1 - parameter * std::pow(std::sin(2 * pi * i / nodes), 2));
    return pi / 2 * sum / nodes;
  };
  CHECK(agrees(boost::math::ellint_1(std::sqrt(m)), by_definition(m), 1e-13));
  CHECK(agrees(std::comp_ellint_1(std::sqrt(m)), by_definition(m), 1e-13));
  CHECK(agrees(tumbling_period(flat_body, omega0), 4 * by_definition(m) / lambda, 1e-13));

  Printed page("modulus");
  page.line("m = {:.6g}, λ = {:.9f} /s", m, lambda);
  page.line("K from its definition:      {:.9f}", by_definition(m));
  page.line("std::comp_ellint_1(√m):     {:.9f}", std::comp_ellint_1(std::sqrt(m)));
  page.line("std::comp_ellint_1(m):      {:.9f}   (wrong: {:.1f} % off)", std::comp_ellint_1(m),
            100 * (1 - std::comp_ellint_1(m) / by_definition(m)));
}
//! [modulus]

//! [flip]
TEST_CASE("The flip: long rest, quick turn, long rest") {
  const double sigma = growth_rate(flat_body, 1);
  CHECK(agrees(sigma, 0.57735026919, 1e-10));

  Printed page("flip");
  page.line("σ = {:.9f} /s", sigma);
  for (const Vector3d& omega0 : {Vector3d(0, 1, 1e-3), Vector3d(1e-3, 1, 0)}) {
    // The interval between two passages of ω₂ through zero: half a period.
    const double interval = tumbling_period(flat_body, omega0) / 2;
    const auto [first, second] = zero_crossings(flat_body, omega0, 1);
    CHECK(agrees(second - first, interval, 1e-8));
    // In the middle between them ω has its old size along axis 2, with the opposite sign.
    CHECK(agrees(integrated(flat_body, omega0, interval).omega[1], -1, 1e-7));
    page.line("ω(0) = {}: the flips follow each other every {:.6f} s; integrated, {:.6f} s", row(omega0), interval,
              second - first);
  }
  CHECK(agrees(tumbling_period(flat_body, {0, 1, 1e-3}) / 2, 26.828560929, 1e-9));
  CHECK(agrees(tumbling_period(flat_body, {1e-3, 1, 0}) / 2, 28.731424437, 1e-9));
}
//! [flip]

//! [flip law]
TEST_CASE("Ten times less disturbance delays the flip by a fixed time: a logarithm, not a period") {
  const double sigma = growth_rate(flat_body, 1);
  const double decade = 2 * std::log(10.0) / sigma;  // 1 − m goes with the square of the disturbance

  Printed page("flip law");
  page.line("{:>11}  {:>14}  {:>18}", "ω₃ at start", "interval (s)", "(1/σ) ln(16/(1−m))");
  double before = 0;
  for (const double disturbance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const Vector3d omega0(0, 1, disturbance);
    const double interval = tumbling_period(flat_body, omega0) / 2;

    // 1 − m = (I₃ − I₁)(L² − 2T·I₂) / ((L² − 2T·I₁)(I₃ − I₂)), by differences that do not cancel.
    const double complement = 2 * (3 * disturbance * disturbance) / ((2 + 6 * disturbance * disturbance) * 1);
    const double law = std::log(16 / complement) / sigma;
    if (disturbance <= 1e-3) CHECK(agrees(interval, law, 1e-6));
    if (disturbance <= 1e-4) CHECK(agrees(interval - before, decade, 1e-5));
    before = interval;
    page.line("{:11.0e}  {:14.6f}  {:18.6f}", disturbance, interval, law);
  }
  CHECK(agrees(std::log(16 / (6e-6 / (2 + 6e-6))) / sigma, 26.828583649, 1e-9));
  page.line("each decade adds 2 ln(10)/σ = {:.6f} s; 2π/σ = {:.6f} s is nowhere to be seen", decade, 2 * pi / sigma);
}
//! [flip law]

//! [lost digits]
TEST_CASE("Close to the separatrix the answer lives on 1 − m, and √m has rounded it away") {
  const double disturbance = 1e-7;
  const double complement = 2 * (3 * disturbance * disturbance) / (2 + 6 * disturbance * disturbance);  // 1 − m
  const double lambda = std::sqrt((2 + 6 * disturbance * disturbance) / 6);

  const double by_modulus = 2 * std::comp_ellint_1(std::sqrt(1 - complement)) / lambda;
  const double by_complement = tumbling_period(flat_body, {0, 1, disturbance}) / 2;

  // The law of the previous example is right here to about the size of 1 − m itself.
  const double law = std::log(16 / complement) / lambda;
  CHECK(agrees(by_complement, law, 1e-10));
  CHECK(std::abs(by_modulus - law) > 1e-6 * law);

  Printed page("lost digits");
  page.line("1 − m = {:.3e}", complement);
  page.line("flip interval from K(k), k = √m:         {:.9f} s", by_modulus);
  page.line("flip interval from R_F(0, 1 − m, 1):     {:.9f} s", by_complement);
  page.line("law ln(16/(1−m)):                        {:.9f} s", law);
}
//! [lost digits]

//! [small limit]
TEST_CASE("At small amplitude the exact period becomes that of the wobble") {
  Printed page("small limit");
  const double wobble = 2 * pi / std::sqrt(linearized_rates(flat_body, 2).prod());
  page.line("2π/√(Ω₁Ω₂) = {:.9f} s about axis 3 with ω₃ = 2 rad/s", wobble);
  for (const double amplitude : {1.0, 0.1, 0.01, 1e-8}) {
    const double period = tumbling_period(flat_body, {amplitude, 0, 2});
    page.line("exact, A = {:5.0e} rad/s: {:.9f} s", amplitude, period);
    // The period differs from its limit only in second order.
    CHECK(std::abs(period / wobble - 1) <= 0.25 * amplitude * amplitude + 1e-14);
  }
  CHECK(agrees(tumbling_period(flat_body, {0, 0, 2}), wobble, 1e-14));  // exactly at the limit
  CHECK(agrees(tumbling_period(flat_body, {-2, 0, 0}), 2 * pi / std::sqrt(linearized_rates({2, 3, 1}, -2).prod()),
               1e-14));
  // With two equal moments the elliptic functions are sine and cosine at any amplitude, and the period is 2π/|Ω|.
  CHECK(agrees(tumbling_period({1, 1, 1.8}, {0.4, 0.3, 2}), 2 * pi / body_precession_rate(1, 1.8, 2), 1e-14));
  CHECK(agrees(tumbling_period({0.5, 2, 2}, {2, 0.4, 0.3}), 2 * pi / std::abs(body_precession_rate(2, 0.5, 2)), 1e-14));
}
//! [small limit]

// ---- hard arguments
// ----------------------------------------------------------------------------------------------------

//! [sphere]
TEST_CASE("A sphere has no precession: ω stays where it is, in the body and in space") {
  const Vector3d omega0(0.3, -0.2, 0.5);
  CHECK(body_precession_rate(2, 2, 0.5) == 0);
  CHECK(agrees(symmetric_top(2, 2, omega0, 123.0), omega0, 1e-15));
  CHECK(agrees(space_precession_rate(2, 2, omega0), omega0.norm(),
               1e-15));  // L is along ω: the axis runs round it with ω
  CHECK(agrees(integrated({2, 2, 2}, omega0, 3).omega, omega0, 1e-13));
  for (int axis = 0; axis < 3; ++axis) CHECK(axis_stability({2, 2, 2}, axis) == 0);
}
//! [sphere]

//! [group law]
TEST_CASE("Time may stand still, run backwards, and be cut into pieces") {
  const Top top;
  const double period = 2 * pi / body_precession_rate(top.I1, top.I3, top.omega3);
  const auto at = [&](const Vector3d& omega, double t) { return symmetric_top(top.I1, top.I3, omega, t); };

  CHECK(agrees(at(top.omega0, 0), top.omega0, 1e-15));
  CHECK(agrees(at(at(top.omega0, 0.7), -0.7), top.omega0, 1e-15));
  CHECK(agrees(at(at(top.omega0, 0.7), 1.1), at(top.omega0, 1.8), 1e-15));
  CHECK(agrees(at(top.omega0, period), top.omega0, 1e-14));
  // Half a period: exactly half a turn, and a hair before and after it nothing jumps.
  const Vector3d opposite(-top.omega0[0], -top.omega0[1], top.omega0[2]);
  for (const double around : {-1e-8, 0.0, 1e-8}) CHECK(agrees(at(top.omega0, period / 2 + around), opposite, 1e-7));
  CHECK(agrees(at(top.omega0, period / 2), opposite, 1e-14));
}
//! [group law]

//! [no wobble]
TEST_CASE("Without a wobble the two rates lose their separate meaning, and only their sum is seen") {
  // θ = 0: L, ω and the axis coincide, and the body simply turns with ω₃.
  const double precession = space_precession_rate(1, 1.8, {0, 0, 2});
  const double own_spin = -body_precession_rate(1, 1.8, 2);
  CHECK(agrees(precession + own_spin, 2, 1e-15));
  CHECK(agrees(symmetric_top(1, 1.8, {0, 0, 2}, 0.7), Vector3d(0, 0, 2), 1e-15));
  // A wobble of 1e-8 moves nothing but itself.
  CHECK(agrees(space_precession_rate(1, 1.8, {1e-8, 0, 2}), precession, 1e-15));
  const Vector3d tiny = symmetric_top(1, 1.8, {1e-8, 0, 2}, 0.7);
  CHECK(agrees(Vector2d(tiny.head<2>()), Vector2d(1e-8 * std::cos(1.12), 1e-8 * std::sin(1.12)), 1e-14));
  // ω across the axis: the top turns about a fixed line, and nothing precesses in the body.
  CHECK(body_precession_rate(1, 1.8, 0) == 0);
  CHECK(agrees(space_precession_rate(1, 1.8, {0.3, 0.4, 0}), 0.5, 1e-15));
}
//! [no wobble]

//! [symmetric limit]
TEST_CASE("With I₂ = I₁ the small wobble is the symmetric top, for either sign of Ω") {
  for (const double I3 : {1.8, 0.5}) {
    for (const double omega3 : {2.0, -2.0}) {
      const double side = body_precession_rate(1, I3, omega3) < 0 ? -1 : 1;
      const double amplitude = 0.01, phase = 0.3, t = 0.7;
      // The two descriptions measure the phase in different senses when Ω is negative.
      const Vector3d start(amplitude * std::cos(phase), side * amplitude * std::sin(phase), omega3);
      const Vector3d exact = symmetric_top(1, I3, start, t);
      CHECK(agrees(linearized_top({1, 1, I3}, omega3, amplitude, phase, t), exact.head<2>(), 1e-13));
    }
  }
}
//! [symmetric limit]
