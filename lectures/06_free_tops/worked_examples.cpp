// Worked examples of lecture 06. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/motion.hpp"
#include "lectures/support/result.hpp"

#include <rigid/free_tops.hpp>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
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

/// A flattened top: I₁ = I₂ = 1, I₃ = 1.8 kg m², amplitude 0.4 rad/s, phase 0.3, ω₃ = 2 rad/s.
struct Top {
  double I1 = 1, I3 = 1.8;
  double amplitude = 0.4, phase = 0.3, omega3 = 2;
  Vector3d I{I1, I1, I3};
  Vector3d omega0{amplitude * std::cos(phase), amplitude* std::sin(phase), omega3};
};

/// An ice-hockey puck: 0.170 kg, 76.2 mm across, 25.4 mm high.
struct Puck {
  double I3 = 0.170 * 0.0381 * 0.0381 / 2;                           // kg m²
  double I1 = 0.170 * (3 * 0.0381 * 0.0381 + 0.0254 * 0.0254) / 12;  // kg m²
  Vector3d I{I1, I1, I3};
  Vector3d omega0{4, 0, 40};  // rad/s
};

/// The third moment is the sum of the other two: a flat body, kg m².
const Vector3d flat_body(1, 2, 3);

double twice_energy(const Vector3d& I, const Vector3d& omega) { return I.dot(omega.cwiseAbs2()); }
double momentum_squared(const Vector3d& I, const Vector3d& omega) { return I.cwiseProduct(omega).squaredNorm(); }

/// The angle through which a vector has gone round the axis L.
double angle_about(const Vector3d& L, const Vector3d& before, const Vector3d& after) {
  const Vector3d across = L.cross(before).normalized(), across_then = L.cross(after).normalized();
  return std::atan2(L.normalized().dot(across.cross(across_then)), across.dot(across_then));
}

/// The first two times after 0 at which ω₂ vanishes, by integration in steps.
std::array<double, 2> flips(const Vector3d& I, const Vector3d& omega0, double step) {
  std::array<double, 2> found{};
  std::size_t count = 0;
  Vector3d omega = omega0;
  for (int i = 0; count < 2; ++i) {
    const Vector3d next = integrated(I, {omega}, step).omega;
    if (omega[1] != 0 && omega[1] * next[1] < 0) {
      const auto at = [&](double t) { return integrated(I, {omega}, t).omega[1]; };
      std::uintmax_t rounds = 60;
      const auto [low, high] =
          boost::math::tools::toms748_solve(at, 0.0, step, boost::math::tools::eps_tolerance<double>(50), rounds);
      found[count++] = i * step + (low + high) / 2;
    }
    omega = next;
  }
  return found;
}

}  // namespace

// ---- the symmetric top

//! [body]
TEST_CASE("body: Seen from a symmetric top, ω goes round the symmetry axis at the steady rate Ω") {
  //! [body in brief]
  const double M = 0.170, r = 0.0381, h = 0.0254;                      // kg, m: a puck
  const double I3 = M * r * r / 2, I1 = M * (3 * r * r + h * h) / 12;  // kg m²
  const Vector3d omega0(4, 0, 40);                                     // rad/s
  const double Omega = body_precession_rate(I1, I3, omega0[2]);
  const Vector3d omega = symmetric_top(I1, I3, omega0, 0.02);
  //! [body in brief]

  CHECK(agrees(omega, integrated({I1, I1, I3}, {omega0}, 0.02).omega, 1e-12));
  const Top top;
  CHECK(agrees(body_precession_rate(top.I1, top.I3, top.omega3), 1.6));
  const Vector3d later = symmetric_top(top.I1, top.I3, top.omega0, 0.7);
  CHECK(agrees(later, Vector3d(0.4 * std::cos(1.6 * 0.7 + 0.3), 0.4 * std::sin(1.6 * 0.7 + 0.3), 2), 1e-14));
  CHECK(agrees(later, integrated(top.I, {top.omega0}, 0.7).omega, 1e-12));
  CHECK(agrees(later, Vector3d(0.06009018796, 0.3954607051, 2), 1e-9));

  result("(I_1, I_3)", 1e4 * Vector2d(I1, I3), "10⁻⁴ kg m²", "the moments of the puck", 4);
  result(R"(\Omega)", Omega, "rad/s", "positive, since the puck is flattened", 4);
  result(R"(\vec\omega)", omega, "rad/s", "20 ms later, as the integration of Euler's equations confirms", 4);
}
//! [body]

TEST_CASE("oblate: The tests of an ephemeris program, with the other sign of the rate") {
  // Moments (3, 3, 9) and L = (0, 5, 7) at time 0 give L(t) = (5 sin Ωt, 5 cos Ωt, 7) with their Ω = L₃(I₁ −
  // I₃)/(I₁I₃). No body has these moments, since 9 > 3 + 3; the equations do not mind.
  const Vector3d I(3, 3, 9), omega0(0, 5.0 / 3, 7.0 / 9);
  const double their_rate = -body_precession_rate(3, 9, omega0[2]);
  for (const double t : {0.0, 0.5, 1.0, 2.0, -1.0}) {
    const Vector3d L = I.cwiseProduct(symmetric_top(3, 9, omega0, t));
    CHECK(agrees(L, Vector3d(5 * std::sin(their_rate * t), 5 * std::cos(their_rate * t), 7), 1e-13));
  }
  result(R"(-\Omega)", their_rate, "rad/s");
}

TEST_CASE("The amplitude carries energy and momentum, and the body sees L go round with ω") {
  const Top top;
  const double T = 0.5 * top.I1 * top.amplitude * top.amplitude + 0.5 * top.I3 * top.omega3 * top.omega3;
  const double rate = body_precession_rate(top.I1, top.I3, top.omega3);
  for (const double t : {0.0, 0.7, 5.0, -3.0}) {
    const Vector3d L = top.I.cwiseProduct(symmetric_top(top.I1, top.I3, top.omega0, t));
    const double angle = rate * t + top.phase;
    CHECK(agrees(L, Vector3d(top.amplitude * std::cos(angle), top.amplitude * std::sin(angle), 3.6), 1e-14));
    CHECK(agrees(0.5 * L.dot(symmetric_top(top.I1, top.I3, top.omega0, t)), T, 1e-14));
    CHECK(agrees(L.norm(), top.I.cwiseProduct(top.omega0).norm(), 1e-14));
    CHECK(agrees(integrated(top.I, {top.omega0}, t).A * L, top.I.cwiseProduct(top.omega0), 1e-12));
  }
}

//! [space]
TEST_CASE("space: The axis goes round L at the rate L/I₁, and the body rotates back under it") {
  const auto [I3, I1, I, omega] = Puck();
  //! [space in brief]
  const double precession = space_precession_rate(I1, I3, omega);   // about L
  const double own_rate = -body_precession_rate(I1, I3, omega[2]);  // about its axis
  const Vector3d L(I1 * omega[0], I1 * omega[1], I3 * omega[2]);
  const double L_from_axis = std::atan2(L.head<2>().norm(), L[2]);
  const double omega_from_axis = std::atan2(omega.head<2>().norm(), omega[2]);
  //! [space in brief]

  // ω is the sum of a rotation about the fixed L and one about the body's own axis.
  CHECK(agrees(precession * L.normalized() + own_rate * Vector3d::UnitZ(), omega, 1e-14));
  // In the integrated attitude, too, the axis has gone through the angle (L/I₁)t about L.
  const Vector3d axis = Vector3d::UnitZ();
  CHECK(agrees(angle_about(L, axis, integrated(I, {omega}, 0.03).A.col(2)), precession * 0.03, 1e-10));
  const Top top;
  CHECK(agrees(space_precession_rate(top.I1, top.I3, top.omega0), 3.622154055255, 1e-12));
  CHECK(agrees(std::acos(top.I.cwiseProduct(top.omega0).normalized()[2]) / degree, 6.340191746, 1e-9));
  CHECK(agrees(std::acos(top.omega0.normalized()[2]) / degree, 11.309932474, 1e-9));

  result(R"(\dot\phi)", precession, "rad/s", R"(about \(\vec L\))", 4);
  result(R"(\dot\psi)", own_rate, "rad/s", "about the own axis, backwards", 4);
  result(R"(\angle(\vec L,\unit e_3))", L_from_axis / degree, "°", "the tilt of the axis", 3);
  result(R"(\angle(\vec\omega,\unit e_3))", omega_from_axis / degree, "°",
         R"(\(\vec L\) lies between \(\vec\omega\) and the axis)", 3);
}
//! [space]

TEST_CASE("The body cone rolls on the space cone without slipping") {
  const Top top;
  // The point of the body that lies on ω at t = 0 is at rest at that moment, and not a quarter of a second later.
  const Vector3d point = top.omega0.normalized();
  CHECK(agrees(integrated(top.I, {top.omega0}, 0).omega.cross(point).norm(), 0, 1e-14, 1));
  CHECK(integrated(top.I, {top.omega0}, 0.25).omega.cross(point).norm() > 0.1);
  // Equal arcs in equal times: at the distance 1 along ω the radii are the sines of the opening angles.
  const Vector3d L = top.I.cwiseProduct(top.omega0);
  const double on_body = body_precession_rate(top.I1, top.I3, top.omega3) * point.cross(Vector3d::UnitZ()).norm();
  const double in_space = space_precession_rate(top.I1, top.I3, top.omega0) * point.cross(L.normalized()).norm();
  CHECK(agrees(on_body, in_space, 1e-14));
}

//! [attitude]
TEST_CASE("attitude: The attitude of a symmetric top in one line") {
  const auto [I3, I1, I, omega] = Puck();
  //! [attitude in brief]
  const double t = 1;  // s, more than six turns
  const double precession = space_precession_rate(I1, I3, omega);
  const double Omega = body_precession_rate(I1, I3, omega[2]);
  const Vector3d L(I1 * omega[0], I1 * omega[1], I3 * omega[2]);
  const Eigen::AngleAxisd about_L(precession * t, L.normalized());
  const Eigen::AngleAxisd about_axis(-Omega * t, Vector3d::UnitZ());
  const Matrix3d A = (about_L * about_axis).toRotationMatrix();
  //! [attitude in brief]

  CHECK(agrees(A, integrated(I, {omega}, t).A, 1e-10));
  const Top top;
  const Vector3d L_top = top.I.cwiseProduct(top.omega0);
  const Matrix3d A_top =
      (Eigen::AngleAxisd(L_top.norm() * 4, L_top.normalized()) * Eigen::AngleAxisd(-1.6 * 4, Vector3d::UnitZ()))
          .toRotationMatrix();
  const Motion later = integrated(top.I, {top.omega0}, 4);
  CHECK(agrees(A_top, later.A, 1e-12));
  CHECK(agrees(A_top * symmetric_top(top.I1, top.I3, top.omega0, 4), later.A * later.omega, 1e-12));

  result(R"(\unit e_3)", A.col(2), "", R"(after 1 s; at the start it was \((0, 0, 1)\))", 4);
}
//! [attitude]

TEST_CASE("From plate to needle: ω never goes round the axis faster than the body spins") {
  // A uniform cylinder of mass M, radius r and height h has I₃ = Mr²/2 and I₁ = M(3r² + h²)/12.
  for (const double height : {0.0, 0.5, 1.0, std::sqrt(3.0), 3.0, 10.0, 1000.0}) {
    const double I3 = 0.5, I1 = (3 + height * height) / 12;
    CHECK(I3 <= 2 * I1);
    CHECK(std::abs(body_precession_rate(I1, I3, 1.0)) <= 1);
  }
  CHECK(agrees(body_precession_rate(0.25, 0.5, 1.0), 1));                    // the plate
  CHECK(agrees(body_precession_rate(0.5, 0.5, 1.0), 0, 1e-14, 1));           // like a sphere: h = √3 r
  CHECK(agrees(body_precession_rate(1e6 / 12 + 0.25, 0.5, 1.0), -1, 1e-5));  // the needle
}

//! [plate]
TEST_CASE("plate: A thrown plate wobbles nearly twice as fast as it spins") {
  //! [plate in brief]
  const double I1 = 1, I3 = 2, omega3 = 1;  // only the ratios matter
  const double tilt = 10 * degree;          // of the axis from L
  const Vector3d omega(I3 / I1 * omega3 * std::tan(tilt), 0, omega3);
  const double wobble = space_precession_rate(I1, I3, omega);
  const double spin = wobble - body_precession_rate(I1, I3, omega3);
  //! [plate in brief]

  CHECK(agrees(wobble / spin, 2 / (2 - std::cos(tilt)), 1e-14));
  const double small = space_precession_rate(1, 2, {2 * std::tan(1e-8), 0, 1});
  CHECK(agrees(small / (small - body_precession_rate(1, 2, 1)), 2, 1e-14));

  result(R"(\dot\phi/(\dot\phi + \dot\psi))", wobble / spin, "", "two wobbles to a turn, nearly");
}
//! [plate]

//! [earth]
TEST_CASE("earth: Euler's ten months, and what was observed") {
  //! [earth in brief]
  const double H = 0.0032737949;    // (I₃ − I₁)/I₃, from the precession of the equinoxes
  const double I3 = 1, I1 = 1 - H;  // only the ratio matters
  const double omega3 = 2 * pi;     // one turn per sidereal day
  const double sidereal_days = 2 * pi / body_precession_rate(I1, I3, omega3);
  const double days = sidereal_days * 86164.0905 / 86400;
  const double observed = 433;  // days
  //! [earth in brief]

  CHECK(agrees(sidereal_days, (1 - H) / H, 1e-12));
  CHECK(agrees(sidereal_days, 304.456, 2e-6));
  CHECK(agrees(days, 303.625, 2e-6));

  result(R"(2\pi/\Omega)", sidereal_days, "sidereal days", "for a rigid Earth", 5);
  result(R"(P_{\mathrm{rigid}})", days, "days", "of 24 hours", 5);
  result(R"(P_{\mathrm{observed}}/P_{\mathrm{rigid}})", observed / days, "",
         "the real Earth takes half as long again, nearly", 3);
}
//! [earth]

// ---- the asymmetric top near an axis

//! [rates]
TEST_CASE("rates: Near axis 3, Euler's first two equations become linear") {
  //! [rates in brief]
  const Vector3d I(2, 3, 1);  // kg m²: axis 3 has the smallest moment
  const Vector2d rates = linearized_rates(I, 5);
  const double frequency = std::sqrt(rates.prod());
  //! [rates in brief]

  CHECK(agrees(rates, Vector2d(-5, -5.0 / 3), 1e-14));
  // Read the two coefficients off Euler's equations themselves. These are quadratic, so a central difference is exact.
  const auto omega_rate = [&](const Vector3d& omega) -> Vector3d {
    return I.cwiseProduct(omega).cross(omega).cwiseQuotient(I);
  };
  CHECK(agrees(-(omega_rate({0, 1, 5}) - omega_rate({0, -1, 5}))[0] / 2, rates[0], 1e-14));
  CHECK(agrees((omega_rate({1, 0, 5}) - omega_rate({-1, 0, 5}))[1] / 2, rates[1], 1e-14));

  result(R"((\Omega_1, \Omega_2))", rates, "rad/s", "both negative", 4);
  result(R"(\sqrt{\Omega_1\Omega_2})", frequency, "rad/s", "of the oscillation below", 4);
}
//! [rates]

//! [slip]
TEST_CASE("slip: With both rates negative, the second component has the opposite sign") {
  const Vector3d I(2, 3, 1);
  //! [slip in brief]
  const double omega3 = 5, amplitude = 1e-5, t = 0.2;  // rad/s, rad/s, s
  const double solved = integrated(I, {{amplitude, 0, omega3}}, t).omega[1];
  const double with_sign = linearized_top(I, omega3, amplitude, 0, t)[1];
  const Vector2d rates = linearized_rates(I, omega3);
  const double angle = std::sqrt(rates.prod()) * t;
  const double without = amplitude * std::sqrt(rates[1] / rates[0]) * std::sin(angle);
  //! [slip in brief]

  // Euler's equations decide: at t = 0 they say dω₂/dt = Ω₂ω₁ < 0, so ω₂ must become negative.
  CHECK(agrees(solved, -3.15121e-6, 1e-5));
  CHECK(agrees(without, -solved, 1e-9));
  CHECK(agrees(with_sign, solved, 1e-9));
  // With the spin reversed both rates are positive, and the formula without the sign is right.
  const Vector2d positive = linearized_rates(I, -omega3);
  const double right = amplitude * std::sqrt(positive[1] / positive[0]) * std::sin(std::sqrt(positive.prod()) * t);
  CHECK(agrees(right, integrated(I, {{amplitude, 0, -omega3}}, t).omega[1], 1e-9));

  result(R"(\tilde\omega_2)", 1e6 * solved, "10⁻⁶ rad/s", "Euler's equations integrated");
  result(R"(\tilde\omega_2)", 1e6 * with_sign, "10⁻⁶ rad/s", R"(with \(\operatorname{sgn}\Omega_1\))");
  result(R"(\tilde\omega_2)", 1e6 * without, "10⁻⁶ rad/s", "without it, as printed on the slides");
}
//! [slip]

TEST_CASE("A small disturbance with a phase solves the linear equations and starts where it should") {
  const Vector3d I(2, 3, 1);
  const auto at = [&](double t) { return linearized_top(I, 5, 0.01, 0.3, t); };
  CHECK(agrees(at(0.2), Vector2d(0.006391911556, -0.004440100099), 1e-9));
  CHECK(agrees(at(0)[0], 0.01 * std::cos(0.3), 1e-14));
  const Vector2d rates = linearized_rates(I, 5);
  for (const double t : {-1.0, 0.0, 0.2, 3.0}) {
    const Vector2d slope = (at(t + 1e-5) - at(t - 1e-5)) / 2e-5;
    CHECK(agrees(slope, Vector2d(-rates[0] * at(t)[1], rates[1] * at(t)[0]), 1e-9, 0.05));
  }
}

//! [small]
TEST_CASE("small: ω₃ is not constant, only nearly: its change is of second order in the disturbance") {
  const Vector3d I(2, 3, 1);
  Eigen::MatrixXd table(4, 3);
  //! [small in brief]
  const double quarter = pi / 2 / std::sqrt(linearized_rates(I, 5).prod());  // s
  int row = 0;
  for (const double amplitude : {0.4, 0.2, 0.1, 0.05}) {  // rad/s
    const Vector3d omega = integrated(I, {{amplitude, 0, 5}}, quarter).omega;
    const Vector2d linear = linearized_top(I, 5, amplitude, 0, quarter);
    table.row(row++) << amplitude, omega[2] - 5, (linear - omega.head<2>()).norm();
  }
  //! [small in brief]

  // Half the disturbance: a quarter of the change of ω₃, an eighth of the error in the small components.
  for (int i = 1; i < 4; ++i) {
    CHECK(agrees(table(i - 1, 1) / table(i, 1), 4, 0.02));
    CHECK(agrees(table(i - 1, 2) / table(i, 2), 8, 0.04));
  }
  result_table({R"(\(\omega_\perp\) / (rad/s))", R"(change of \(\tilde\omega_3\) / (rad/s))",
                R"(error of \(\tilde\omega_1, \tilde\omega_2\) / (rad/s))"},
               table, 3);
}
//! [small]

//! [ranks]
TEST_CASE("ranks: Stable about the largest and the smallest moment, unstable about the one between") {
  Eigen::MatrixXd table(3, 4);
  //! [ranks in brief]
  const Vector3d I(1.21e-3, 16.38e-3, 17.48e-3);  // kg m²: a tennis racket
  for (int axis = 0; axis < 3; ++axis) {
    // The axis in question becomes axis 3.
    const Vector3d renamed(I[(axis + 1) % 3], I[(axis + 2) % 3], I[axis]);
    const Vector2d rates = linearized_rates(renamed, 1);
    table.row(axis) << axis + 1, 1e3 * I[axis], rates.prod(), axis_stability(I, axis);
  }
  //! [ranks in brief]

  // The rank decides, not the number. And a disturbed rotation strays or does not.
  for (const Vector3d& J : {I, Vector3d(2, 3, 1), Vector3d(3, 1, 2)}) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vector2d rates = linearized_rates({J[(axis + 1) % 3], J[(axis + 2) % 3], J[axis]}, 1);
      Vector3d omega0 = Vector3d::Constant(1e-6);
      omega0[axis] = 1;
      double strayed = 0;
      for (int i = 0; i <= 40; ++i) {
        Vector3d omega = integrated(J, {omega0}, 0.5 * i).omega;
        omega[axis] = 0;
        strayed = std::max(strayed, omega.norm());
      }
      CHECK(axis_stability(J, axis) == (rates.prod() > 0 ? 1 : -1));
      CHECK((axis_stability(J, axis) == 1) == (strayed < 2e-5));
    }
  }
  CHECK(axis_stability({2, 3, 1}, 0) == -1);

  result_table({"axis", R"(moment / (10⁻³ kg m²))", R"(\(\Omega_1\Omega_2/\omega^2\))", "axis_stability"}, table, 3);
}
//! [ranks]

TEST_CASE("Neutral: a symmetric top strays along its equator, linearly at first; a sphere does not stray at all") {
  const Vector3d I(1, 1, 1.8), omega0(1, 0, 1e-4);
  CHECK(axis_stability(I, 0) == 0);
  CHECK(axis_stability(I, 2) == 1);
  for (const double t : {10.0, 20.0, 40.0, 30000.0}) {
    const Vector3d omega = integrated(I, {omega0}, t).omega;
    CHECK(agrees(omega[1], std::sin(0.8e-4 * t), 1e-9));  // the rate is Ω = 0.8·10⁻⁴ rad/s
    if (t < 100) CHECK(agrees(omega[1], 0.8e-4 * t, 1e-5));
  }
  for (int axis = 0; axis < 3; ++axis) CHECK(axis_stability({2, 2, 2}, axis) == 0);
  const Vector3d disturbed(1, 1e-4, -2e-4);
  CHECK(agrees(integrated({2, 2, 2}, {disturbed}, 40).omega, disturbed, 1e-13));
}

//! [growth]
TEST_CASE("growth: About the intermediate axis a disturbance grows as exp(σt)") {
  //! [growth in brief]
  const Vector3d I(1.21e-3, 16.38e-3, 17.48e-3);  // kg m²: a tennis racket
  const double omega2 = 10;                       // rad/s, end over end
  const double sigma = growth_rate(I, omega2);
  const double in_one_turn = std::exp(sigma * 2 * pi / omega2);
  //! [growth in brief]

  // Start from a disturbance of one part in 10⁹. After a while only its growing part is left.
  const auto grown = [](const Vector3d& J, double spin, double from, double to) {
    const Vector3d start(1e-9 * spin, spin, 0);
    return std::log(integrated(J, {start}, to).omega[0] / integrated(J, {start}, from).omega[0]) / (to - from);
  };
  CHECK(agrees(grown(I, omega2, 0.8, 1.2), sigma, 1e-4));
  CHECK(agrees(grown(flat_body, 1.5, 8, 12), growth_rate(flat_body, 1.5), 1e-5));
  CHECK(agrees(growth_rate(flat_body, 1.5), 1.5 / std::sqrt(3.0), 1e-14));  // (1·1)/(1·3) under the root
  CHECK(agrees(growth_rate(flat_body, 1.5), 0.8660254038, 1e-9));
  CHECK(agrees(growth_rate(flat_body, 1), 0.57735026919, 1e-10));
  CHECK(agrees(growth_rate(flat_body, -1.5), growth_rate(flat_body, 1.5), 1e-14));

  result(R"(\sigma)", sigma, "1/s", "the growth rate", 4);
  result(R"(e^{\sigma\cdot2\pi/\omega_2})", in_one_turn, "", "the growth during a single turn", 3);
}
//! [growth]

TEST_CASE("Of all bodies with the same I₂/I₃ the flat one is the most unstable") {
  // For I₂/I₃ = x the rate is largest when I₁ is as small as a body allows, I₁ = I₃ − I₂: σ/ω₂ = √(2x − 1) < 1.
  for (const double x : {0.55, 0.7, 0.9, 0.99}) {
    const double flat = growth_rate({1 - x, x, 1}, 1);
    CHECK(agrees(flat, std::sqrt(2 * x - 1), 1e-13));
    CHECK(flat < 1);
    for (const double more : {1.05, 1.2}) CHECK(growth_rate({std::min(x, more * (1 - x)), x, 1}, 1) < flat);
  }
  CHECK(agrees(growth_rate({1, 1, 2}, 1), 0, 1e-14, 1));  // two equal moments: nothing grows
  CHECK(agrees(growth_rate({1, 2, 2}, 1), 0, 1e-14, 1));
}

//! [amplitude]
TEST_CASE("amplitude: The amplitude follows from energy and angular momentum at any moment") {
  //! [amplitude in brief]
  const Vector3d I(1, 2, 3);  // kg m²
  const Vector3d omega = integrated(I, {{0.3, 0, 2}}, 0.55).omega;
  const double twice_T = I.dot(omega.cwiseAbs2());
  const double L_squared = I.cwiseProduct(omega).squaredNorm();
  const double more = twice_T * I[2] - L_squared;
  const double amplitude = std::sqrt(more / (I[0] * (I[2] - I[0])));
  const double extra = twice_T / 2 - L_squared / (2 * I[2]);
  //! [amplitude in brief]

  CHECK(std::abs(omega[0]) < 0.9 * amplitude);
  CHECK(agrees(amplitude, 0.3, 1e-11));
  CHECK(agrees(extra, I[0] * (I[2] - I[0]) / (2 * I[2]) * amplitude * amplitude, 1e-11));
  CHECK(extra > 0);
  // About the smallest moment: less energy than without the disturbance.
  const Vector3d J(2, 3, 1), other = integrated(J, {{0.3, 0, 2}}, 0.55).omega;
  const double less = twice_energy(J, other) / 2 - momentum_squared(J, other) / (2 * J[2]);
  CHECK(agrees(less, J[0] * (J[2] - J[0]) / (2 * J[2]) * 0.09, 1e-11));
  CHECK(less < 0);

  result(R"(\vec\omega)", omega, "rad/s", "at that moment", 4);
  result(R"(\omega_\perp)", amplitude, "rad/s", "as at the start");
  result("T - L^2/2I_3", extra, "J", R"(more than the pure rotation with this \(\vec L\))");
}
//! [amplitude]

// ---- the asymmetric top at any amplitude

TEST_CASE("ω goes round axis 3 or axis 1, and L² against 2T·I₂ decides which") {
  for (const Vector3d& omega0 : {Vector3d(0.1, 1, 0.1), Vector3d(1, 0.5, 0.25)}) {
    const double excess = momentum_squared(flat_body, omega0) - twice_energy(flat_body, omega0) * flat_body[1];
    const int circled = excess > 0 ? 2 : 0;
    // During a full period the component along that axis never changes its sign, the others do, and ω stays on the two
    // ellipsoids.
    Eigen::Vector3i changes = Eigen::Vector3i::Zero();
    Vector3d before = omega0;
    for (int i = 0; i < 100; ++i) {
      const Vector3d now = integrated(flat_body, {before}, tumbling_period(flat_body, omega0) / 100).omega;
      changes += (now.cwiseProduct(before).array() < 0).matrix().cast<int>();
      before = now;
      CHECK(agrees(twice_energy(flat_body, now), twice_energy(flat_body, omega0), 1e-11));
      CHECK(agrees(momentum_squared(flat_body, now), momentum_squared(flat_body, omega0), 1e-11));
    }
    CHECK(changes[circled] == 0);
    CHECK(changes[1] == 2);
    CHECK(changes[2 - circled] == 2);
  }
}

//! [explorer]
TEST_CASE("explorer: Explorer 1 kept its angular momentum, but not its energy") {
  //! [explorer in brief]
  const double M = 13.97, r = 0.076, length = 2.05;  // kg, m: taken as a uniform cylinder
  const double I_along = M * r * r / 2;
  const double I_across = M * (3 * r * r + length * length) / 12;
  const double spin = 750 * 2 * pi / 60;  // rad/s about the long axis
  const Vector2d heat_and_rate = flat_spin({I_along, I_across, I_across}, {spin, 0, 0});
  const double end_over_end = heat_and_rate[1] * 60 / (2 * pi);  // turns per minute
  const double energy_left = 1 - heat_and_rate[0] / (I_along * spin * spin / 2);
  //! [explorer in brief]

  // Same L: energies L²/2I, rates L/I.
  CHECK(agrees(I_along * 750, I_across * end_over_end, 1e-14));
  CHECK(agrees(energy_left, I_across * end_over_end * end_over_end / (I_along * 750 * 750), 1e-12));
  // Friction of the kind of the figure, dL/dt = L×ω + κ L×(L×ω), keeps the length of L and lowers T.
  const Vector3d I(1, 2, 3);
  const auto friction = [&](const Motion& now) -> Vector3d {
    const Vector3d L = I.cwiseProduct(now.omega);
    return 0.1 * L.cross(L.cross(now.omega));
  };
  Motion now{{1, 0.05, 0.05}};
  double T = twice_energy(I, now.omega) / 2;
  const double L_squared = momentum_squared(I, now.omega);
  for (int i = 0; i < 300; ++i) {
    now = integrated(I, now, 1, friction);
    const double T_now = twice_energy(I, now.omega) / 2;
    CHECK(T_now <= T + 1e-13);
    CHECK(agrees(momentum_squared(I, now.omega), L_squared, 1e-10));
    T = T_now;
  }
  CHECK(agrees(T, L_squared / (2 * I[2]), 1e-6));  // it ends with the largest moment

  result(R"(n_{\mathrm{end\ over\ end}})", end_over_end, "turns per minute", R"(with the same \(\vec L\))", 3);
  result(R"(T_{\mathrm{end}}/T_{\mathrm{start}})", energy_left, "", "the rest became heat", 3);
}
//! [explorer]

//! [solution]
TEST_CASE("solution: Jacobi's functions against the integration of Euler's equations") {
  const Vector3d I = flat_body, omega0(0.1, 1, 0.1);
  const double twice_T = twice_energy(I, omega0), L_squared = momentum_squared(I, omega0);
  //! [solution in brief]
  const double more = twice_T * I[2] - L_squared, less = L_squared - twice_T * I[0];
  const double nu = std::sqrt(less * (I[2] - I[1]) / I.prod());
  const double k = std::sqrt(more * (I[1] - I[0]) / (less * (I[2] - I[1])));
  const Vector3d a = largest_rates(I, omega0);
  const Vector3d at_0(a[0], 0, a[2]);  // where u = 0
  double cn = 0, dn = 0;
  const double sn = boost::math::jacobi_elliptic(k, nu * 20, &cn, &dn);
  const Vector3d omega = a.cwiseProduct(Vector3d(cn, sn, dn));  // 20 s after at_0
  //! [solution in brief]

  CHECK(agrees(omega, integrated(I, {at_0}, 20).omega, 1e-11));

  // From the start itself, which has the phase u₀.
  const double u0 = boost::math::ellint_1(k, std::atan2(omega0[1] / a[1], omega0[0] / a[0]));
  const double sn_later = boost::math::jacobi_elliptic(k, nu * 20 + u0, &cn, &dn);
  const Vector3d from_start = a.cwiseProduct(Vector3d(cn, sn_later, dn));
  CHECK(agrees(from_start, integrated(I, {omega0}, 20).omega, 1e-11));
  CHECK(agrees(from_start, Vector3d(.6760625658002, .7435989558382, .3987733662439), 1e-11));
  CHECK(agrees(k * k, 0.980582524272, 1e-11));
  CHECK(agrees(nu, 0.585946527708, 1e-11));
  // The other kind of motion, with the labels 1 and 3 exchanged, and the signs of the third kind of start.
  for (const Vector3d& start : {Vector3d(1, 0.5, 0.25), Vector3d(-1, 0.5, 0.25), Vector3d(0.2, -0.1, -1)}) {
    Vector3d J = flat_body, w = start;
    const bool exchanged = momentum_squared(J, w) < twice_energy(J, w) * J[1];
    if (exchanged) {
      std::swap(J[0], J[2]);
      std::swap(w[0], w[2]);
    }
    const double above = twice_energy(J, w) * J[2] - momentum_squared(J, w);
    const double below = momentum_squared(J, w) - twice_energy(J, w) * J[0];
    const Vector3d most =
        Vector3d(above / (J[0] * (J[2] - J[0])), above / (J[1] * (J[2] - J[1])), below / (J[2] * (J[2] - J[0])))
            .cwiseSqrt();
    const double rate = std::sqrt(below * (J[2] - J[1]) / J.prod()), sense = w[2] < 0 ? -1 : 1;
    const double modulus = std::sqrt(above * (J[1] - J[0]) / (below * (J[2] - J[1])));
    const double from = boost::math::ellint_1(modulus, std::atan2(sense * w[1] / most[1], w[0] / most[0]));
    const double s = boost::math::jacobi_elliptic(modulus, rate * 20 + from, &cn, &dn);
    Vector3d later(most[0] * cn, sense * most[1] * s, sense * most[2] * dn);
    if (exchanged) std::swap(later[0], later[2]);
    CHECK(agrees(later, integrated(flat_body, {start}, 20).omega, 1e-11));
    CHECK(agrees(tumbling_period(flat_body, start), 4 * boost::math::ellint_1(modulus) / rate, 1e-12));
  }

  result(R"(k^2)", k * k, "", "close to 1: the start is close to axis 2");
  result(R"(\nu)", nu, "1/s", R"(the rate of \(u\))");
  result(R"(\vec\omega)", at_0, "rad/s", R"(where \(u = 0\))");
  result(R"(\vec\omega)", omega, "rad/s", "20 s later; the integration agrees to eleven digits");
}
//! [solution]

//! [period]
TEST_CASE("period: In closed form, by watching the motion, and with the modulus mistaken for the parameter") {
  const Vector3d I = flat_body, omega0(0.1, 1, 0.1);
  const double less = momentum_squared(I, omega0) - twice_energy(I, omega0) * I[0];
  const double more = twice_energy(I, omega0) * I[2] - momentum_squared(I, omega0);
  const double nu = std::sqrt(less * (I[2] - I[1]) / I.prod());
  const double k = std::sqrt(more * (I[1] - I[0]) / (less * (I[2] - I[1])));
  //! [period in brief]
  const double P = tumbling_period(I, {0.1, 1, 0.1});
  const double right = 4 * std::comp_ellint_1(k) / nu;      // C++ takes the modulus k
  const double wrong = 4 * std::comp_ellint_1(k * k) / nu;  // and no parameter k²
  //! [period in brief]

  CHECK(agrees(P, right, 1e-12));
  CHECK(agrees(P, 22.996262944122, 1e-12));
  CHECK(agrees(tumbling_period(I, {1, 0.5, 0.25}), 10.809345300803, 1e-12));
  for (const Vector3d& start : {omega0, Vector3d(1, 0.5, 0.25)}) {
    // ω₂ vanishes twice in a period, half a period apart. After a period ω is what it was, and not after half of one.
    const double period = tumbling_period(I, start);
    const auto [first, second] = flips(I, start, 0.25);
    CHECK(agrees(2 * (second - first), period, 1e-10));
    CHECK(agrees(integrated(I, {start}, period).omega, start, 1e-10));
    CHECK((integrated(I, {start}, period / 2).omega - start).norm() > 0.1);
  }
  // K from its definition; over a full turn of a periodic integrand equal steps are all one needs.
  double by_definition = 0;
  for (int i = 0; i < 400; ++i)
    by_definition += pi / 800 / std::sqrt(1 - 0.35 * std::pow(std::sin(2 * pi * i / 400), 2));
  CHECK(agrees(std::comp_ellint_1(std::sqrt(0.35)), by_definition, 1e-13));
  CHECK(agrees(boost::math::ellint_1(std::sqrt(0.35)), by_definition, 1e-13));

  result("P", P, "s", R"(as \(4K(k)/\nu\) gives with the library's function)", 4);
  result(R"(P_{\mathrm{wrong}})", wrong, "s", R"(with \(k^2\) where the library wants \(k\))", 4);
}
//! [period]

//! [flip]
TEST_CASE("flip: A tennis racket that is thrown end over end twists by half a turn") {
  //! [flip in brief]
  const Vector3d I(1.21e-3, 16.38e-3, 17.48e-3);  // kg m²: a tennis racket
  const Vector3d omega0(0, 10, 0.5);              // rad/s
  const double interval = tumbling_period(I, omega0) / 2;
  const double first = interval / 2;
  //! [flip in brief]

  const auto [watched, next] = flips(I, omega0, 0.02);
  CHECK(agrees(watched, first, 1e-9));
  CHECK(agrees(next - watched, interval, 1e-9));
  CHECK(integrated(I, {omega0}, 2 * pi / 10).omega[1] < -8);  // after one turn most of the twist is done
  for (const Vector3d& start : {Vector3d(0, 1, 1e-3), Vector3d(1e-3, 1, 0)}) {
    const double half_period = tumbling_period(flat_body, start) / 2;
    const auto [one, two] = flips(flat_body, start, 0.25);
    CHECK(agrees(two - one, half_period, 1e-8));
    CHECK(agrees(integrated(flat_body, {start}, half_period).omega[1], -1, 1e-7));
  }
  CHECK(agrees(tumbling_period(flat_body, {0, 1, 1e-3}) / 2, 26.828560929, 1e-9));
  CHECK(agrees(tumbling_period(flat_body, {1e-3, 1, 0}) / 2, 28.731424437, 1e-9));

  result(R"(t_1)", first, "s", "until the middle of the first twist", 3);
  result(R"(10\,t_1/2\pi)", first * 10 / (2 * pi), "", "turns end over end by then", 2);
  result("P/2", interval, "s", "from one twist to the next", 3);
}
//! [flip]

//! [law]
TEST_CASE("law: Ten times less disturbance delays the first flip by a fixed time") {
  const double sigma = growth_rate(flat_body, 1);
  Eigen::MatrixXd table(6, 4);
  //! [law in brief]
  const Vector3d I(1, 2, 3);  // kg m²
  int row = 0;
  for (const double disturbance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const double P = tumbling_period(I, {0, 1, disturbance});
    const double squared = disturbance * disturbance;
    const double complement = 6 * squared / (2 + 6 * squared);  // 1 − k²
    table.row(row++) << disturbance, P / 4, P / 2, std::log(16 / complement) / sigma;
  }
  //! [law in brief]

  for (int i = 0; i < 6; ++i) {
    if (table(i, 0) <= 1.1e-3) CHECK(agrees(table(i, 2), table(i, 3), 1e-6));
    if (table(i, 0) <= 1.1e-4) CHECK(agrees(table(i, 2) - table(i - 1, 2), 2 * std::log(10.0) / sigma, 1e-5));
  }
  CHECK(agrees(table(2, 3), 26.828583649, 1e-9));
  // The first flips, as they were seen in another integration, and as they are in this one.
  CHECK(agrees(Vector3d(table(1, 1), table(2, 1), table(3, 1)), Vector3d(9.4255, 13.4143, 17.4025), 1e-5));
  for (int i = 1; i < 4; ++i) CHECK(agrees(flips(I, {0, 1, table(i, 0)}, 0.25)[0], table(i, 1), 1e-7));

  result_table({R"(\(\tilde\omega_3(0)\) / (rad/s))", "first flip / s", "interval / s",
                R"(\(\tfrac1\sigma\ln\tfrac{16}{1-k^2}\) / s)"},
               table, 4);
  result(R"(\ln 10/\sigma)", std::log(10.0) / sigma, "s", "the delay of the first flip per decade");
}
//! [law]

//! [digits]
TEST_CASE("digits: Close to the separatrix the answer depends on 1 − k², and k has rounded it away") {
  //! [digits in brief]
  const double squared = 1e-7 * 1e-7;
  const double complement = 6 * squared / (2 + 6 * squared);  // 1 − k²
  const double nu = std::sqrt((2 + 6 * squared) / 6);
  const double by_modulus = 2 * std::comp_ellint_1(std::sqrt(1 - complement)) / nu;
  const double by_complement = tumbling_period(flat_body, {0, 1, 1e-7}) / 2;
  //! [digits in brief]

  const double law = std::log(16 / complement) / nu;  // right to about the size of 1 − k² here
  CHECK(agrees(by_complement, law, 1e-10));
  CHECK(std::abs(by_modulus - law) > 1e-6 * law);

  result("P/2", by_modulus, "s", R"(from \(K(k)\))", 9);
  result("P/2", by_complement, "s", R"(from \(R_F(0, 1-k^2, 1)\))", 9);
}
//! [digits]

TEST_CASE("On the separatrix ω₂ is a tanh: the body leaves the axis, flips once, and never does it again") {
  // L² = 2T·I₂, with ω₂ = −tanh σt: it comes from +1 and goes to −1.
  const double sigma = growth_rate(flat_body, 1);
  const double first = std::sqrt(2 * (3 - 2) / (1.0 * (3 - 1))), third = std::sqrt(2 * (2 - 1) / (3.0 * (3 - 1)));
  for (const double t : {-6.0, -1.0, 0.0, 0.5, 3.0}) {
    const double fall = 1 / std::cosh(sigma * t);
    const Vector3d exact(first * fall, -std::tanh(sigma * t), -third * fall);
    CHECK(agrees(momentum_squared(flat_body, exact), 2 * twice_energy(flat_body, exact), 1e-14));
    CHECK(agrees(integrated(flat_body, {{first, 0, -third}}, t).omega, exact, 1e-9));
  }
}

TEST_CASE("At small amplitude the exact period becomes that of the linear theory") {
  const double linear = 2 * pi / std::sqrt(linearized_rates(flat_body, 2).prod());
  for (const double amplitude : {1.0, 0.1, 0.01, 1e-8}) {
    // They differ in second order only.
    const double period = tumbling_period(flat_body, {amplitude, 0, 2});
    CHECK(std::abs(period / linear - 1) <= 0.25 * amplitude * amplitude + 1e-14);
  }
  CHECK(agrees(tumbling_period(flat_body, {0, 0, 2}), linear, 1e-14));  // exactly at the limit
  CHECK(agrees(tumbling_period(flat_body, {-2, 0, 0}), 2 * pi / std::sqrt(linearized_rates({2, 3, 1}, -2).prod()),
               1e-14));
  // With two equal moments the elliptic functions are sine and cosine at any amplitude, and the period is 2π/|Ω|.
  CHECK(agrees(tumbling_period({1, 1, 1.8}, {0.4, 0.3, 2}), 2 * pi / body_precession_rate(1, 1.8, 2), 1e-14));
  CHECK(agrees(tumbling_period({0.5, 2, 2}, {2, 0.4, 0.3}), 2 * pi / std::abs(body_precession_rate(2, 0.5, 2)), 1e-14));
}

// ---- hard arguments

TEST_CASE("A sphere has no precession: ω stays where it is, in the body and in space") {
  const Vector3d omega0(0.3, -0.2, 0.5);
  CHECK(body_precession_rate(2, 2, 0.5) == 0);
  CHECK(agrees(symmetric_top(2, 2, omega0, 123.0), omega0, 1e-15));
  CHECK(agrees(space_precession_rate(2, 2, omega0), omega0.norm(), 1e-15));  // L is along ω: the axis goes round with ω
}

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

TEST_CASE("Without an amplitude the two rates lose their separate meaning, and only their sum is seen") {
  const double precession = space_precession_rate(1, 1.8, {0, 0, 2});
  CHECK(agrees(precession - body_precession_rate(1, 1.8, 2), 2, 1e-15));
  CHECK(agrees(symmetric_top(1, 1.8, {0, 0, 2}, 0.7), Vector3d(0, 0, 2), 1e-15));
  // An amplitude of 1e-8 moves nothing but itself.
  CHECK(agrees(space_precession_rate(1, 1.8, {1e-8, 0, 2}), precession, 1e-15));
  const Vector3d tiny = symmetric_top(1, 1.8, {1e-8, 0, 2}, 0.7);
  CHECK(agrees(Vector2d(tiny.head<2>()), Vector2d(1e-8 * std::cos(1.12), 1e-8 * std::sin(1.12)), 1e-14));
  // ω across the axis: the top rotates about a fixed line, and nothing precesses in the body.
  CHECK(body_precession_rate(1, 1.8, 0) == 0);
  CHECK(agrees(space_precession_rate(1, 1.8, {0.3, 0.4, 0}), 0.5, 1e-15));
}

TEST_CASE("With I₂ = I₁ the small disturbance is the symmetric top, for either sign of Ω") {
  for (const double I3 : {1.8, 0.5}) {
    for (const double omega3 : {2.0, -2.0}) {
      const double side = body_precession_rate(1, I3, omega3) < 0 ? -1 : 1;
      const double amplitude = 0.01, phase = 0.3, t = 0.7;
      // The two descriptions count the phase in opposite senses when Ω is negative.
      const Vector3d start(amplitude * std::cos(phase), side * amplitude * std::sin(phase), omega3);
      const Vector3d exact = symmetric_top(1, I3, start, t);
      CHECK(agrees(linearized_top({1, 1, I3}, omega3, amplitude, phase, t), exact.head<2>(), 1e-13));
    }
  }
}
