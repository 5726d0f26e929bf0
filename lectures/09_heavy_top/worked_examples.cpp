// Worked examples of lecture 09. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/motion.hpp"
#include "lectures/support/result.hpp"

#include <rigid/euler_angles.hpp>
#include <rigid/heavy_top.hpp>
#include <rigid/kinetic_energy.hpp>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace rigid;
using workbook::agrees;
using workbook::AngleMotion;
using workbook::Motion;
using workbook::result;
using workbook::result_table;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
constexpr double arcsecond = degree / 3600;
constexpr double day = 86400, year = 365.25 * day;
const Vector3d vertical = Vector3d::UnitZ();

/// The motion after a time, by the angles and heavy_top_accelerations.
AngleMotion moved(const Vector3d& I, double Mgl, const AngleMotion& start, double time) {
  return workbook::integrated(
      start, time, [&](const Vector3d& q, const Vector3d& v) { return heavy_top_accelerations(I, Mgl, q, v); });
}

/// The same by Euler's equations with the torque Mgl ê3⁰ × ê3 and dA/dt = A [ω̃]×: no angle, no function of the course.
Motion moved_without_angles(const Vector3d& I, double Mgl, const Motion& start, double time) {
  return workbook::integrated(I, start, time, [Mgl](const Motion& now) -> Vector3d {
    return Mgl * (now.A.transpose() * vertical).cross(Vector3d::UnitZ());
  });
}

/// How the body of these angles stands and rotates.
Motion as_motion(const AngleMotion& motion) {
  return {angular_velocity_body(motion.angles, motion.rates), rotation_matrix(motion.angles).transpose()};
}

/// A third route, for a symmetric top: ê3 and λ = L/I₁ in space obey dê3/dt = λ × ê3 and dλ/dt = (Mgl/I₁) ê3⁰ × ê3,
/// whatever I₃ is. Bulirsch and Stoer's method follows them, which is not one of Runge and Kutta.
class AxisInSpace {
 public:
  AxisInSpace(double I1, double I3, double Mgl, double theta, const Vector3d& rates) : pull_(Mgl / I1) {
    const Vector3d e3(std::sin(theta), 0, std::cos(theta)), spin = (rates[2] + rates[0] * e3.z()) * e3;
    // Across the axis L is I₁ times ω, along it I₃ times.
    const Vector3d across = rates[0] * (vertical - e3.z() * e3) + rates[1] * Vector3d::UnitY();
    Vector3d::Map(state_.data()) = e3;
    Vector3d::Map(state_.data() + 3) = across + I3 / I1 * spin;
  }
  void advance(double time) {
    const auto system = [&](const State& now, State& rate, double) {
      const Vector3d e3 = Vector3d::Map(now.data()), lambda = Vector3d::Map(now.data() + 3);
      Vector3d::Map(rate.data()) = lambda.cross(e3);
      Vector3d::Map(rate.data() + 3) = pull_ * vertical.cross(e3);
    };
    boost::numeric::odeint::bulirsch_stoer<State> stepper(1e-14, 1e-14);
    const double before = azimuth();
    boost::numeric::odeint::integrate_adaptive(stepper, system, state_, 0.0, time, time / 4);
    turned_ += std::remainder(azimuth() - before, 2 * pi);
  }
  Vector3d axis() const { return Vector3d::Map(state_.data()); }
  double theta() const { return std::atan2(std::hypot(axis().x(), axis().y()), axis().z()); }
  /// Of the axis, upwards.
  double rise() const { return state_[3] * state_[1] - state_[4] * state_[0]; }
  /// The angle through which it went round the vertical; many calls of advance() make it reliable.
  double turned() const { return turned_; }

 private:
  using State = std::array<double, 6>;
  double azimuth() const { return std::atan2(state_[1], state_[0]); }

  double pull_, turned_ = 0;
  State state_{};
};

/// Limits, period and advance of one nutation that begins at its smallest inclination, from the motion in space.
struct Nutation {
  double largest, period, advance;
};

Nutation followed(AxisInSpace top, double guess) {
  const double h = guess / 200;
  double time = 0;
  const auto until_it = [&](bool rises) {  // back by halving until the moment is known
    while ((top.rise() > 0) != rises) {
      top.advance(h);
      time += h;
    }
    AxisInSpace late = top;
    const auto rise = [&](double back) {
      late = top;
      if (back > 0) late.advance(-back);
      return late.rise();
    };
    std::uintmax_t iterations = 60;
    const auto [from, to] =
        boost::math::tools::toms748_solve(rise, 0.0, h, boost::math::tools::eps_tolerance<double>(50), iterations);
    top.advance(-(from + to) / 2);
    time -= (from + to) / 2;
  };
  top.advance(h);  // the axis sinks at first
  time += h;
  until_it(true);
  const double largest = top.theta();
  top.advance(h);
  time += h;
  until_it(false);
  return {largest, time, top.turned()};
}

}  // namespace

//! [conserved]
TEST_CASE("conserved: Three quantities that the weight does not change") {
  //! [conserved in brief]
  const double I1 = 3.28e-4, I3 = 6.6e-5, Mgl = 0.0456;  // kg m², kg m², J: a toy top
  const Vector3d I(I1, I1, I3);
  const AngleMotion start{{0, 30 * degree, 0}, {0, 0, 200}};  // rad, rad/s: its axis is at rest
  const AngleMotion end = moved(I, Mgl, start, 2);            // s
  const Vector3d p = canonical_momenta(I, start.angles, start.rates);
  const Vector3d p_end = canonical_momenta(I, end.angles, end.rates);
  const auto E = [&](const AngleMotion& now) {
    const double theta = now.angles[1];
    return kinetic_energy_symmetric(I1, I3, theta, now.rates) + Mgl * std::cos(theta);
  };
  //! [conserved in brief]

  CHECK(agrees(Vector2d(p_end[0], p_end[2]), Vector2d(p[0], p[2]), 1e-11));
  CHECK(agrees(E(end), E(start), 1e-11));
  // The other two routes lead to the same place.
  const Motion without_angles = moved_without_angles(I, Mgl, as_motion(start), 2);
  CHECK(agrees(without_angles.A, as_motion(end).A, 1e-8));
  AxisInSpace top(I1, I3, Mgl, start.angles[1], start.rates);
  for (int i = 0; i < 400; ++i) top.advance(2.0 / 400);
  CHECK(agrees(top.axis(), without_angles.A.col(2), 1e-9));
  CHECK(agrees(top.turned(), end.angles[0], 1e-9));
  // φ̇ and ψ̇ follow from θ and the momenta.
  const double s = std::sin(end.angles[1]), c = std::cos(end.angles[1]);
  CHECK(agrees(end.rates[0], (p[0] - p[2] * c) / (I1 * s * s), 1e-8));
  CHECK(agrees(end.rates[2], p[2] / I3 - end.rates[0] * c, 1e-9));

  result(R"((\theta,\ \phi))", Vector2d(end.angles[1], end.angles[0]) / degree, "°", "after 2 s, in all three ways");
  result(R"((p_\phi,\ p_\psi))", 1e3 * Vector2d(p_end[0], p_end[2]), "10⁻³ kg m²/s", "as at the start");
  result("E", Vector2d(E(start), E(end)), "J", "at the start and after 2 s");
}
//! [conserved]

//! [accelerations]
TEST_CASE("accelerations: What the weight does to the angles") {
  //! [accelerations in brief]
  const Vector3d top(3.28e-4, 3.28e-4, 6.6e-5);  // kg m²
  const Vector3d angles(0.3, 30 * degree, 1.1), at_rest(0, 0, 0);
  const Vector3d of_top = heavy_top_accelerations(top, 0.0456, angles, at_rest);
  // A board of 0.5 kg, 20 cm wide and 30 cm high, on the middle of its lower edge.
  const double about_height = 0.5 * 0.04 / 12, about_width = 0.5 * 0.09 / 3;
  const Vector3d board(about_width, about_width + about_height, about_height);
  const Vector3d of_board = heavy_top_accelerations(board, 0.5 * 9.81 * 0.15, angles, at_rest);
  //! [accelerations in brief]

  CHECK(agrees(of_top, Vector3d(0, 0.0456 * std::sin(angles[1]) / top[0], 0), 1e-13));
  // In motion: along the path that Euler's equations with the torque take, the angles have these second derivatives.
  const Vector3d rates(5, -2, 9);
  const double Mgl = 0.0456;
  for (const Vector3d& I : {top, board}) {
    const auto angles_at = [&](double t) -> Vector3d {
      const Matrix3d A = moved_without_angles(I, Mgl, as_motion({angles, rates}), t).A;
      return {std::atan2(A(1, 2), A(0, 2)), std::atan2(std::hypot(A(0, 2), A(1, 2)), A(2, 2)),
              std::atan2(A(2, 1), -A(2, 0))};
    };
    const double h = 2e-3;
    const Vector3d by_differences =
        (16 * (angles_at(h) + angles_at(-h)) - (angles_at(2 * h) + angles_at(-2 * h)) - 30 * angles_at(0)) /
        (12 * h * h);
    CHECK(agrees(heavy_top_accelerations(I, Mgl, angles, rates), by_differences, 1e-6));
    CHECK(agrees(heavy_top_accelerations(I, 0, angles, rates), euler_angle_accelerations(I, angles, rates), 1e-13));
  }

  result(R"((\ddot\phi,\ \ddot\theta,\ \ddot\psi)_{\text{top}})", of_top, "rad/s²", "of the top, at rest", 4);
  result(R"((\ddot\phi,\ \ddot\theta,\ \ddot\psi)_{\text{board}})", of_board, "rad/s²", "of the board, at rest", 4);
}
//! [accelerations]

//! [potential]
TEST_CASE("potential: The energy at which a top turns round, and the bottom of its well") {
  //! [potential in brief]
  const double I1 = 3.28e-4, I3 = 6.6e-5, Mgl = 0.0456;  // kg m², kg m², J
  const double theta0 = 30 * degree;
  const double p_psi = I3 * 200, p_phi = p_psi * std::cos(theta0);  // released at θ₀, its axis at rest
  const auto U = [&](double theta) { return effective_potential(I1, I3, Mgl, p_phi, p_psi, theta); };
  const auto [bottom, least] = boost::math::tools::brent_find_minima(U, 0.1, 3.0, 52);
  //! [potential in brief]

  // With θ̇ = 0 the energy of the released top is the potential at θ₀.
  const Vector3d I(I1, I1, I3), rates(0, 0, 200);
  CHECK(agrees(U(theta0), kinetic_energy_symmetric(I1, I3, theta0, rates) + Mgl * std::cos(theta0), 1e-14));
  // The equation of θ is that of a particle in this potential: I₁ θ̈ = −∂U/∂θ, here by differences.
  for (const double theta : {0.4, 0.7, 1.3, 2.5}) {
    const double phi_rate = (p_phi - p_psi * std::cos(theta)) / (I1 * std::pow(std::sin(theta), 2)), h = 1e-3;
    const Vector3d now(phi_rate, 0, p_psi / I3 - phi_rate * std::cos(theta));
    const double slope = (8 * (U(theta + h) - U(theta - h)) - (U(theta + 2 * h) - U(theta - 2 * h))) / (12 * h);
    CHECK(agrees(I1 * heavy_top_accelerations(I, Mgl, {0, theta, 0}, now)[1], -slope, 1e-7));
  }
  // At the bottom the same momenta belong to a steady precession, the slow one.
  const double rate = (p_phi - p_psi * std::cos(bottom)) / (I1 * std::pow(std::sin(bottom), 2));
  CHECK(agrees(rate, steady_precession(I1, I3, Mgl, 200, bottom)[0], 1e-6));

  result(R"(U_{\mathrm{eff}}(\theta_0))", U(theta0), "J", "which is the energy");
  result(R"(U_{\mathrm{eff}}(\theta_0) - U_{\mathrm{eff},\min})", 1e3 * (U(theta0) - least), "mJ",
         "the depth of the well below it", 4);
  result(R"(\theta_{\min})", bottom / degree, "°", "the bottom, about which the top nods", 4);
}
//! [potential]

//! [steady]
TEST_CASE("steady: The heavy top has two steady precessions, a slow and a fast one") {
  //! [steady in brief]
  const double I1 = 3.28e-4, I3 = 6.6e-5, Mgl = 0.0456;  // kg m², kg m², J
  const double theta = 30 * degree, omega3 = 200;        // rad/s
  const Vector2d standing = steady_precession(I1, I3, Mgl, omega3, theta);
  const Vector2d hanging = steady_precession(I1, I3, Mgl, omega3, pi - theta);
  const double least = 2 * std::sqrt(I1 * Mgl * std::cos(theta)) / I3;
  //! [steady in brief]

  const Vector3d I(I1, I1, I3);
  const auto stays = [&](double inclination, double rate) {
    const AngleMotion start{{0.2, inclination, -0.7}, {rate, 0, omega3 - rate * std::cos(inclination)}};
    // No acceleration; and in motion the inclination is the same half a second later.
    CHECK(agrees(heavy_top_accelerations(I, Mgl, start.angles, start.rates), Vector3d::Zero(), 1e-12,
                 start.rates.squaredNorm()));
    const AngleMotion later = moved(I, Mgl, start, 0.5);
    CHECK(agrees(Vector2d(later.angles[0], later.angles[1]), Vector2d(0.2 + 0.5 * rate, inclination), 1e-9));
    // L goes round with the axis, and its change is the torque of the weight.
    const Vector3d L =
        rotation_matrix(start.angles).transpose() * I.cwiseProduct(angular_velocity_body(start.angles, start.rates));
    const Vector3d axis = rotation_matrix(start.angles).transpose().col(2);
    CHECK(agrees((rate * vertical).cross(L), Mgl * vertical.cross(axis), 1e-12));
  };
  for (const double rate : standing) stays(theta, rate);
  for (const double rate : hanging) stays(pi - theta, rate);
  // At the least spin the two rates meet.
  const Vector2d meeting = steady_precession(I1, I3, Mgl, least * 1.0011, theta);
  CHECK(agrees(meeting[0], meeting[1], 0.1));
  CHECK(agrees(meeting.prod(), Mgl / (I1 * std::cos(theta)), 1e-12));
  // The root that is a small difference loses digits: of 5·10⁻⁶ rad/s beside 500 rad/s only eight are left.
  const double weak = 1e-6 * Mgl, a = I1 * std::cos(theta), b = I3 * 2000;
  const double by_subtraction = (b - std::sqrt(b * b - 4 * a * weak)) / (2 * a);
  const double exact = steady_precession(I1, I3, weak, 2000, theta)[0];
  CHECK(agrees(exact, weak / b * (1 + a * weak / (b * b)), 1e-14));
  CHECK_FALSE(agrees(by_subtraction, exact, 1e-10));

  result(R"((\dot\phi_{\text{slow}},\ \dot\phi_{\text{fast}}))", standing, "rad/s", "of the top that stands");
  result(R"(Mg\ell/(I_3\tilde\omega_3))", Mgl / (I3 * omega3), "rad/s", "of the gyroscope formula, for comparison");
  result(R"((\dot\phi_{\text{slow}},\ \dot\phi_{\text{fast}})_{\text{hanging}})", hanging, "rad/s",
         "30° from the downward vertical");
  result(R"(\tilde\omega_{3,\min})", least, "rad/s", "the least spin of a steady precession at 30°");
}
//! [steady]

//! [sleeping]
TEST_CASE("sleeping: How fast a top must spin to stand upright") {
  //! [sleeping in brief]
  const double I1 = 3.28e-4, I3 = 6.6e-5, Mgl = 0.0456;  // kg m², kg m², J: the toy top
  const double awake = sleeping_spin(I1, I3, Mgl);
  // A pencil on its tip: 5 g, 17.5 cm long, 3.5 mm in radius.
  const double m = 0.005, length = 0.175, radius = 0.0035;
  const double across = m * (length * length / 3 + radius * radius / 4), along = m * radius * radius / 2;
  const double pencil = sleeping_spin(across, along, m * 9.81 * length / 2);
  // The toy top 5 % below: how far from the vertical does it go?
  const double beta = std::pow(0.95 * I3 * awake, 2) / (4 * I1 * Mgl);
  const double farthest = std::acos(2 * beta - 1);
  //! [sleeping in brief]

  // Tilted by 0.001 rad and let go, without and with 5 % more spin.
  const auto largest_tilt = [&](double spin) {
    AxisInSpace top(I1, I3, Mgl, 1e-3, {0, 0, spin});
    double largest = 0;
    for (int i = 0; i < 4000; ++i) {
      top.advance(1e-3);
      largest = std::max(largest, top.theta());
    }
    return largest;
  };
  CHECK(largest_tilt(1.05 * awake) < 0.01);
  CHECK(agrees(largest_tilt(0.95 * awake), farthest, 1e-3));
  // The curvature of the effective potential changes its sign there. It is even in θ.
  const auto curvature = [&](double spin) {
    const double p = I3 * spin;
    const auto U = [&](double theta) { return effective_potential(I1, I3, Mgl, p, p, theta) - p * p / (2 * I3); };
    return (16 * (U(0.02) - U(0.01)) - (U(0.04) - U(0.02))) / (0.5 * 12 * 3e-4);
  };
  CHECK(curvature(0.999 * awake) < 0);
  CHECK(curvature(1.001 * awake) > 0);

  result(R"(\omega)", awake, "rad/s", "when the toy top wakes");
  result(R"(\omega/2\pi)", Vector2d(awake, pencil) / (2 * pi), "turns per second", "of the toy top and of the pencil",
         4);
  result(R"(\theta_{\max})", farthest / degree, "°", "of the toy top with 5 % less than it needs", 4);
}
//! [sleeping]

//! [nutation]
TEST_CASE("nutation: Released, the heavy top nods between two angles") {
  //! [nutation in brief]
  const double I1 = 3.28e-4, I3 = 6.6e-5, Mgl = 0.0456;  // kg m², kg m², J
  const double theta0 = 30 * degree, omega3 = 200;       // rad/s; its axis is at rest
  const double beta = std::pow(I3 * omega3, 2) / (4 * I1 * Mgl), u0 = std::cos(theta0);
  const double theta1 = std::acos(beta - std::sqrt(beta * beta - 2 * beta * u0 + 1));

  const Vector2d limits = nutation_limits(I1, I3, Mgl, theta0, {0, 0, omega3});
  const Vector2d pushed = nutation_limits(I1, I3, Mgl, theta0, {2, 1, omega3});
  //! [nutation in brief]

  CHECK(agrees(limits, Vector2d(theta0, theta1), 1e-12));
  const Nutation in_space = followed(AxisInSpace(I1, I3, Mgl, theta0, {0, 0, omega3}), 0.15);
  CHECK(agrees(in_space.largest, theta1, 1e-12));
  // At both limits the energy is the effective potential.
  for (const Vector3d& rates : {Vector3d(0, 0, omega3), Vector3d(2, 1, omega3)}) {
    const Vector3d p = canonical_momenta({I1, I1, I3}, {0, theta0, 0}, rates);
    const double energy = kinetic_energy_symmetric(I1, I3, theta0, rates) + Mgl * u0;
    for (const double limit : nutation_limits(I1, I3, Mgl, theta0, rates))
      CHECK(agrees(effective_potential(I1, I3, Mgl, p[0], p[2], limit), energy, 1e-12));
  }

  result(R"((\theta_0,\ \theta_1))", limits / degree, "°", "released at rest", 4);
  result(R"(\theta_0 + \sin\theta_0/(2\beta))", (theta0 + std::sin(theta0) / (2 * beta)) / degree, "°",
         "for a fast top", 4);
  result(R"((\theta_{\min},\ \theta_{\max}))", pushed / degree, "°",
         R"(pushed with \(\dot\phi = 2\) and \(\dot\theta = 1\) rad/s)", 4);
}
//! [nutation]

//! [paths]
TEST_CASE("paths: The rate of precession at both limits, for four releases") {
  //! [paths in brief]
  const double I1 = 3.28e-4, I3 = 6.6e-5, Mgl = 0.0456;  // kg m², kg m², J
  const double theta0 = 40 * degree, omega3 = 200;       // rad/s
  Eigen::MatrixXd table(4, 4);
  for (int row = 0; const double push : {0.0, 2.6, -5.0, 10.0}) {
    const Vector3d rates(push, 0, omega3 - push * std::cos(theta0));
    const Vector3d p = canonical_momenta({I1, I1, I3}, {0, theta0, 0}, rates);
    const double theta1 = nutation_limits(I1, I3, Mgl, theta0, rates).sum() - theta0;  // not the start
    const double rate = (p[0] - p[2] * std::cos(theta1)) / (I1 * std::pow(std::sin(theta1), 2));
    table.row(row++) << push, std::acos(p[0] / p[2]) / degree, theta1 / degree, rate;
  }
  //! [paths in brief]

  // A motion in space reaches these limits with these rates.
  for (int row = 0; row < 4; ++row) {
    const double push = table(row, 0);
    const Vector3d rates(push, 0, omega3 - push * std::cos(theta0));
    AxisInSpace top(I1, I3, Mgl, theta0, rates);
    top.advance(nutation_period(I1, I3, Mgl, theta0, rates) / 2);
    CHECK(agrees(top.theta(), table(row, 2) * degree, 1e-9));
    const double before = top.turned();
    top.advance(1e-5);
    CHECK(agrees((top.turned() - before) / 1e-5, table(row, 3), 1e-4));
  }
  // φ̇ vanishes at the limit, outside, and between the limits.
  CHECK(agrees(table(0, 1), theta0 / degree, 1e-12));
  CHECK(table(1, 1) < theta0 / degree);
  CHECK(table(2, 1) > theta0 / degree);
  CHECK(table(2, 1) < table(2, 2));
  CHECK(table(3, 1) > table(3, 2));
  CHECK(table(3, 1) < theta0 / degree);
  // Released at rest, the axis precesses at its lowest twice as fast as the gyroscope formula says, exactly.
  CHECK(agrees(table(0, 3), 2 * Mgl / (I3 * omega3), 1e-12));

  result_table({R"(\(\dot\phi\) at 40° / (rad/s))", R"(\(\dot\phi = 0\) at / °)", R"(other limit / °)",
                R"(\(\dot\phi\) there / (rad/s))"},
               table, 4);
}
//! [paths]

//! [tapped]
TEST_CASE("tapped: A top in steady precession is tapped, and nods") {
  Eigen::MatrixXd table(3, 3);
  //! [tapped in brief]
  const double I1 = 3.28e-4, mgl = 0.0456;  // kg m², J: the toy top
  const double theta = 60 * degree;
  int row = 0;
  for (const double rate : {2.0, 10.0, 50.0}) {  // rad/s, of the steady precession
    const double nods = nutation_frequency(I1, mgl, theta, rate);
    table.row(row++) << rate, nods, nods / rate;
  }
  //! [tapped in brief]

  // The axis followed in angles: tapped so little that the period is that of a small nutation.
  const double I3 = 6.6e-5;
  for (int i = 0; i < row; ++i) {
    const double rate = table(i, 0), spin = (I1 * std::cos(theta) * rate + mgl / rate) / I3;
    const Vector3d rates(rate, 2e-3 * table(i, 1), spin - rate * std::cos(theta));
    CHECK(agrees(2 * pi / nutation_period(I1, I3, mgl, theta, rates), table(i, 1), 1e-4));
  }
  result_table({R"(\(\dot\phi\) / (rad/s))", R"(\(\nu\) / (rad/s))", "nods in a round"}, table, 4);
}
//! [tapped]

//! [period]
TEST_CASE("period: The faster the spin, the smaller and quicker the nutation, and the slower the precession") {
  //! [period in brief]
  const double I1 = 3.28e-4, I3 = 6.6e-5, Mgl = 0.0456;  // kg m², kg m², J
  const double theta0 = 30 * degree;
  Eigen::MatrixXd table(4, 6);
  for (int row = 0; const double spin : {110.0, 200.0, 400.0, 1000.0}) {
    const Vector3d rates(0, 0, spin);
    const Vector2d limits = nutation_limits(I1, I3, Mgl, theta0, rates);
    const double P = nutation_period(I1, I3, Mgl, theta0, rates);
    const double turned = precession_per_nutation(I1, I3, Mgl, theta0, rates);
    table.row(row++) << spin, (limits[1] - limits[0]) / degree, 1e3 * P,  //
        1e3 * 2 * pi * I1 / (I3 * spin), turned / P, Mgl / (I3 * spin);
  }
  //! [period in brief]

  for (int row = 0; row < 4; ++row) {
    const double spin = table(row, 0), P = 1e-3 * table(row, 2);
    const Nutation in_space = followed(AxisInSpace(I1, I3, Mgl, theta0, {0, 0, spin}), 2 * pi * I1 / (I3 * spin));
    CHECK(agrees(P, in_space.period, 1e-9));
    CHECK(agrees(table(row, 4), in_space.advance / in_space.period, 1e-9));
  }
  // With u̇² = (2Mgl/I₁)(u₀ − u)(u − u₁)(u₂ − u) the period is an integral, here for 200 rad/s.
  const double beta = std::pow(I3 * 200, 2) / (4 * I1 * Mgl), u0 = std::cos(theta0);
  const double root = std::sqrt(beta * beta - 2 * beta * u0 + 1), u1 = beta - root, u2 = beta + root;
  const auto inverse_rate = [&](double x) {
    const double u = (u0 + u1) / 2 + (u0 - u1) / 2 * std::cos(x);
    return 2 / std::sqrt(2 * Mgl / I1 * (u2 - u));
  };
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
  CHECK(agrees(1e-3 * table(1, 2), Quadrature::integrate(inverse_rate, 0.0, pi), 1e-12));
  // The fast top: twice the spin, a quarter of the amplitude, half the period, half the rate.
  CHECK(agrees(table(3, 1) * std::pow(1000.0 / 400, 2), table(2, 1), 0.05));
  CHECK(agrees(table(3, 3), table(3, 2), 0.01));
  CHECK(agrees(table(3, 5), table(3, 4), 0.01));

  result_table({R"(\(\tilde\omega_3\) / (rad/s))", R"(\(\theta_1 - \theta_0\) / °)", R"(\(P\) / ms)",
                R"(\(2\pi I_1/(I_3\tilde\omega_3)\) / ms)", R"(\(\Delta\phi/P\) / (rad/s))",
                R"(\(Mg\ell/(I_3\tilde\omega_3)\) / (rad/s))"},
               table, 4);
}
//! [period]

//! [planets]
TEST_CASE("planets: Why the equinoxes move") {
  //! [planets in brief]
  // Moments in units of I₃; rotations against the stars.
  const double mars_spin = 2 * pi / 88642.663, mars_year = 686.98 * day, mars_tilt = 25.19 * degree;
  const double mars = planet_precession_rate(1 - 0.00538, 1, mars_spin, 2 * pi / mars_year, mars_tilt);
  const double I1 = 1 - 0.0032737949, spin = 7.292115e-5, tilt = 84381.406 * arcsecond;  // Earth
  const double n_sun = 2 * pi / (365.25636 * day), n_moon = 2 * pi / (27.321662 * day);
  const double by_sun = planet_precession_rate(I1, 1, spin, n_sun, tilt);
  // GM/R³ is n²; of the Moon's n² only the share of its own mass pulls at the Earth.
  const double share = 1 / (1 + 81.3006);
  const double by_moon = planet_precession_rate(I1, 1, spin, n_moon * std::sqrt(share), tilt);
  //! [planets in brief]

  // Against numbers from elsewhere, once orbits are eccentric and inclined: a mean of 1/R³, and of the latitude of the
  // Moon.
  const auto eccentric = [](double e) { return std::pow(1 - e * e, -1.5); };
  const double inclined = 1 - 1.5 * std::pow(std::sin(5.145 * degree), 2);
  CHECK(agrees(eccentric(0.0934) * mars * year / arcsecond, -7.594, 4e-3));
  CHECK(
      agrees((eccentric(0.0167) * by_sun + eccentric(0.0549) * inclined * by_moon) * year / arcsecond, -50.407, 3e-3));
  // The torque of the tidal forces on six masses, ±1 m from the centre, for the Earth and the Sun; then its mean over a
  // year. Lengths and masses are arbitrary.
  const Vector3d axis(std::sin(tilt), 0, std::cos(tilt)), across = Vector3d::UnitY(), other = axis.cross(across);
  Vector3d mean = Vector3d::Zero();
  for (int month = 0; month < 12; ++month) {
    const Vector3d sun(std::cos(month * pi / 6), std::sin(month * pi / 6), 0);
    for (const auto& [arm, mass] : {std::pair{across, 0.25}, {other, 0.25}, {axis, I1 / 2 - 0.25}}) {
      const Vector3d force = mass * n_sun * n_sun * (3 * sun.dot(arm) * sun - arm);
      mean += 2 * arm.cross(force) / 12;
    }
  }
  CHECK(agrees(mean, by_sun * spin * vertical.cross(axis), 1e-10));

  result(R"(\dot\phi_{\text{Mars}})", mars * year / arcsecond, "″ per year", "observed: −7.594 ± 0.010", 4);
  result(R"((\dot\phi_{\text{Sun}},\ \dot\phi_{\text{Moon}}))", Vector2d(by_sun, by_moon) * year / arcsecond,
         "″ per year", "for the Earth", 4);
  result(R"(\dot\phi_{\text{Earth}})", (by_sun + by_moon) * year / arcsecond, "″ per year",
         "the two together; outside value −50.41", 4);
  result(R"(2\pi/|\dot\phi_{\text{Earth}}|)", 2 * pi / std::abs(by_sun + by_moon) / year, "years",
         "for one turn of the axis", 3);
}
//! [planets]

// Not on the page.
TEST_CASE("laws: What holds of every heavy top") {
  const double I1 = 4e-4, I3 = 9e-5, Mgl = 0.06;
  const Vector3d rates(2, 0.5, 150), mirror(-1, 1, -1);
  // Spin and precession mirrored: the same nutation, the opposite advance.
  CHECK(agrees(nutation_limits(I1, I3, Mgl, 0.5, rates.cwiseProduct(mirror)), nutation_limits(I1, I3, Mgl, 0.5, rates),
               1e-12));
  CHECK(agrees(precession_per_nutation(I1, I3, Mgl, 0.5, rates.cwiseProduct(mirror)),
               -precession_per_nutation(I1, I3, Mgl, 0.5, rates), 1e-12));
  // Backwards in time.
  CHECK(agrees(nutation_period(I1, I3, Mgl, 0.5, rates.cwiseProduct(Vector3d(1, -1, 1))),
               nutation_period(I1, I3, Mgl, 0.5, rates), 1e-12));
  // Only I₁, I₃ω₃ and Mgl matter for the axis: with another I₃ and the same momentum it moves alike.
  const double omega3 = rates[2] + rates[0] * std::cos(0.5);
  const Vector3d slower(2, 0.5, omega3 / 2 - 2 * std::cos(0.5));
  CHECK(agrees(precession_per_nutation(I1, 2 * I3, Mgl, 0.5, slower), precession_per_nutation(I1, I3, Mgl, 0.5, rates),
               1e-12));
  // Almost without weight the axis goes round L on a circle: one nutation is one turn.
  CHECK(agrees(nutation_period(I1, I3, 1e-9, 0.5, rates) *
                   Vector3d(std::hypot(2 * std::sin(0.5), 0.5), 0, I3 * omega3 / I1).norm(),
               2 * pi, 1e-6));
}
