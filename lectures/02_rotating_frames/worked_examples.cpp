// Worked examples of lecture 02. Each case is a paragraph of the notes that computes its own numbers.
#include "lectures/support/agrees.hpp"
#include "lectures/support/printed.hpp"

#include <rigid/frame_derivatives.hpp>
#include <rigid/rotating_frames.hpp>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/numeric/odeint.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

using namespace rigid;
using workbook::agrees;
using workbook::Printed;
using workbook::row;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
constexpr double earth_rate = 7.292115e-5;   // rad/s, one turn against the stars
constexpr double sidereal_day = 86164.0905;  // s

// The motion of this lecture's running example.
const Vector3d example_a(0.1, 0.2, 0.3);
const Vector3d example_v(0.4, -0.3, 0.6);
const Vector3d example_r(1, 2, -1);
const Vector3d example_omega(0.3, -0.2, 0.5);
const Vector3d example_alpha(0.05, 0.1, -0.04);

Vector3d turned(const Vector3d& vector, const Vector3d& w, double t) {
  return rotated_basis(Matrix3d::Identity(), w, t) * vector;
}

/// A frame that spins about an axis while that axis turns about another; ω and α are known in closed form.
struct SpinningAndPrecessing {
  Vector3d spin{0.7, -0.4, 1.1};
  Vector3d precession{0.3, 0.5, -0.2};

  Matrix3d basis(double t) const { return rotated_basis(rotated_basis(Matrix3d::Identity(), spin, t), precession, t); }
  Vector3d omega(double t) const { return precession + turned(spin, precession, t); }
  /// Only the axis of the spin moves.
  Vector3d alpha(double t) const { return precession.cross(turned(spin, precession, t)); }
};

/// A path in the moving frame, with its derivatives there.
Vector3d path(double t) { return {std::cos(t), 0.5 * t * t, std::exp(-t)}; }
Vector3d path_velocity(double t) { return {-std::sin(t), t, -std::exp(-t)}; }
Vector3d path_acceleration(double t) { return {-std::cos(t), 1, std::exp(-t)}; }

/// Second derivative by five points: the error is of fourth order in the step.
template <class Function>
Vector3d second_derivative(const Function& f, double t) {
  const double h = 5e-3;
  return (-f(t - 2 * h) + 16 * f(t - h) - 30 * f(t) + 16 * f(t + h) - f(t + 2 * h)) / (12 * h * h);
}

/// First derivative by five points.
template <class Function>
Vector3d derivative(const Function& f, double t) {
  const double h = 1e-3;
  return (f(t - 2 * h) - 8 * f(t - h) + 8 * f(t + h) - f(t + 2 * h)) / (12 * h);
}

struct Motion {
  Vector3d r;
  Vector3d v;
};

/// Position and velocity after a time, integrated from an acceleration that depends on both.
Motion moved(const Motion& start, double time,
             const std::function<Vector3d(const Vector3d&, const Vector3d&)>& acceleration) {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 6>;
  using Map = Eigen::Map<const Vector3d>;
  State y{start.r.x(), start.r.y(), start.r.z(), start.v.x(), start.v.y(), start.v.z()};
  const auto system = [&](const State& now, State& rate, double) {
    const Vector3d a = acceleration(Map(now.data()), Map(now.data() + 3));
    rate = {now[3], now[4], now[5], a.x(), a.y(), a.z()};
  };
  odeint::integrate_adaptive(odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(1e-13, 1e-13), system, y,
                             0.0, time, time / 100);
  return {Map(y.data()), Map(y.data() + 3)};
}

/// Degrees, minutes and seconds of arc as radians.
double from_arc(double degrees, double minutes, double seconds) {
  return (degrees + minutes / 60 + seconds / 3600) * degree;
}

}  // namespace

//! [four terms]
TEST_CASE("The four terms of the acceleration, against finite differences of a moving frame") {
  const SpinningAndPrecessing frame;
  for (const double t : {-1.3, 0.0, 0.8, 2.4}) {
    // The inertial observer notes positions at neighbouring times, and knows nothing of frames.
    const Vector3d measured = second_derivative([&](double s) -> Vector3d { return frame.basis(s) * path(s); }, t);

    const Matrix3d E = frame.basis(t);
    const Vector3d by_terms = inertial_acceleration(E * path_acceleration(t), E * path_velocity(t), E * path(t),
                                                    frame.omega(t), frame.alpha(t));

    CHECK(agrees(by_terms, measured, 1e-8));
  }

  const Vector3d a = inertial_acceleration(example_a, example_v, example_r, example_omega, example_alpha);
  CHECK(agrees(a, Vector3d(-0.42, -0.39, 0.36), 1e-14));

  Printed page("four terms");
  page.line("in the frame   a         = {}", row(example_a));
  page.line("Coriolis       2 ω×v     = {}", row(2 * example_omega.cross(example_v)));
  page.line("Euler          α×r       = {}", row(example_alpha.cross(example_r)));
  page.line("centripetal    ω×(ω×r)   = {}", row(example_omega.cross(example_omega.cross(example_r))));
  page.line("inertial, m/s²           = {}", row(a));
}
//! [four terms]

//! [transport twice]
TEST_CASE("Transporting twice gives the same, and shows where the 2 comes from") {
  // First to the velocity …
  const Vector3d velocity = inertial_rate(example_v, example_omega, example_r);
  // … and then to its rate, which the body finds by the product rule: a + α × r + ω × v.
  const Vector3d seen_from_body = example_a + example_alpha.cross(example_r) + example_omega.cross(example_v);
  const Vector3d acceleration = inertial_rate(seen_from_body, example_omega, velocity);

  CHECK(agrees(acceleration, inertial_acceleration(example_a, example_v, example_r, example_omega, example_alpha),
               1e-14));

  Printed page("transport twice");
  page.line("v + ω×r = {} m/s", row(velocity));
  page.line("its inertial rate = {} m/s²", row(acceleration));
}
//! [transport twice]

//! [brackets]
TEST_CASE("Where the brackets stand in ω×ω×r decides between zero and the centripetal acceleration") {
  const Vector3d& w = example_omega;
  const Vector3d from_left = w.cross(w).cross(example_r);
  const Vector3d from_right = w.cross(w.cross(example_r));

  CHECK(agrees(from_left, Vector3d::Zero(), 0.0, 1));

  // From the right it is −ω² times the part of r across the axis: towards the axis, not towards the origin.
  const Vector3d across = example_r - w * w.dot(example_r) / w.squaredNorm();
  CHECK(agrees(from_right, -w.squaredNorm() * across, 1e-14));
  CHECK(agrees(from_right.dot(w), 0.0, 1e-15, 1));

  Printed page("brackets");
  page.line("(ω×ω)×r  = {}", row(from_left));
  page.line("ω×(ω×r)  = {} m/s²", row(from_right));
  page.line("−ω² r    = {} m/s², something else", row(-w.squaredNorm() * example_r));
}
//! [brackets]

//! [one alpha]
TEST_CASE("The rate of ω is the same in both frames") {
  const SpinningAndPrecessing frame;
  const double t = 0.8;

  const Vector3d inertial = derivative([&](double s) -> Vector3d { return frame.omega(s); }, t);
  const Vector3d body =
      frame.basis(t) * derivative([&](double s) -> Vector3d { return frame.basis(s).transpose() * frame.omega(s); }, t);

  // The transport theorem applied to ω itself adds ω × ω.
  CHECK(agrees(inertial, body, 1e-10));
  CHECK(agrees(inertial, frame.alpha(t), 1e-10));

  Printed page("one alpha");
  page.line("dω/dt inertial = {} rad/s²", row(inertial, "{:.6f}"));
  page.line("dω/dt body     = {} rad/s²", row(body, "{:.6f}"));
}
//! [one alpha]

//! [fictitious forces]
TEST_CASE("Fictitious forces: what the turning observer must add to keep Newton's second law") {
  const double m = 2;
  const Vector3d force = fictitious_force(m, example_r, example_v, example_omega, example_alpha);
  CHECK(agrees(force, Vector3d(1.04, 1.18, -0.12), 1e-14));

  // The real force of the inertial frame and the fictitious one together make m a_body.
  const Vector3d real = m * inertial_acceleration(example_a, example_v, example_r, example_omega, example_alpha);
  CHECK(agrees(real + force, m * example_a, 1e-14, 1));

  // At rest in a steady frame only the centrifugal force is left, and it points away from the axis.
  const Vector3d centrifugal = fictitious_force(m, example_r, Vector3d::Zero(), example_omega, Vector3d::Zero());
  const Vector3d n = example_omega.normalized();
  const Vector3d from_axis = example_r - n * n.dot(example_r);
  CHECK(agrees(centrifugal, m * example_omega.squaredNorm() * from_axis, 1e-14));
  CHECK(centrifugal.dot(from_axis) > 0);

  Printed page("fictitious forces");
  page.line("fictitious force = {} N", row(force));
  page.line("real force       = {} N", row(real));
  page.line("together, m a    = {} N", row(real + force));
}
//! [fictitious forces]

//! [puck]
TEST_CASE("The puck on the turntable: a straight line, seen by somebody who turns") {
  // No friction, no force: in the inertial frame the puck goes straight. The turntable turns at 1 rad/s.
  const Vector3d omega(0, 0, 1);
  const Vector3d r0(-1, 0, 0), v0(0.5, 0.1, 0);  // inertial
  const double time = 3;

  // Where it is on the turntable follows from where the turntable is.
  const Vector3d seen = turned(r0 + v0 * time, omega, -time);

  // The rider integrates Newton's law with fictitious forces and no others.
  const auto with_coriolis_factor = [&](double factor) {
    return moved({r0, v0 - omega.cross(r0)}, time, [&, factor](const Vector3d& r, const Vector3d& v) -> Vector3d {
      return fictitious_force(1, r, factor / 2 * v, omega, Vector3d::Zero());
    });
  };
  const Vector3d computed = with_coriolis_factor(2).r;
  CHECK(agrees(computed, seen, 1e-11));

  // A wrong turn: without the factor 2 the rider predicts a place where the puck is not.
  const Vector3d without_two = with_coriolis_factor(1).r;
  CHECK((without_two - seen).norm() > 1);

  Printed page("puck");
  page.line("after {} s on the turntable:", time);
  page.line("  straight line, turned back      {} m", row(seen.head<2>(), "{:.6f}"));
  page.line("  with the fictitious forces      {} m", row(computed.head<2>(), "{:.6f}"));
  page.line("  Coriolis force without its 2    {} m", row(without_two.head<2>(), "{:.6f}"));
}
//! [puck]

//! [tree and carousel]
TEST_CASE("Seen from a carousel a tree runs in a circle, and the Coriolis force holds it there") {
  const Vector3d omega(0, 0, 2);
  const Vector3d r(0, 1, 0.5);
  const Vector3d v = -omega.cross(r);  // the tree stands still in the inertial frame

  const Vector3d coriolis = fictitious_force(1, Vector3d::Zero(), v, omega, Vector3d::Zero());
  const Vector3d centrifugal = fictitious_force(1, r, Vector3d::Zero(), omega, Vector3d::Zero());
  const Vector3d from_axis(0, 1, 0);

  // The centrifugal force pulls out with m ω² ρ; the Coriolis force pulls in with twice that. The rest is just what
  // keeps the tree on its circle.
  CHECK(agrees(centrifugal, 4 * from_axis, 1e-15));
  CHECK(agrees(coriolis, -8 * from_axis, 1e-15));
  const Vector3d a_body = coriolis + centrifugal;
  CHECK(agrees(a_body, omega.cross(omega.cross(r)), 1e-15));
  CHECK(agrees(inertial_acceleration(a_body, v, r, omega, Vector3d::Zero()), Vector3d::Zero(), 1e-15, 1));

  Printed page("tree and carousel");
  page.line("centrifugal {:+.0f} N/kg outwards, Coriolis {:+.0f} N/kg outwards, sum {:+.0f}", centrifugal.y(),
            coriolis.y(), a_body.y());
}
//! [tree and carousel]

//! [east north up]
TEST_CASE("The Coriolis acceleration on the local axes, against the same on axes of the whole Earth") {
  const double latitude = 40 * degree;
  const Vector3d v(30, -20, 10);  // east, north, up

  const Vector3d a = coriolis_acceleration(v, latitude, earth_rate);
  CHECK(agrees(a, Vector3d(-0.002992129303, -0.002812368702, 0.003351650505), 1e-9));

  // On the Earth's own axes, z through the north pole, Ω has one component. East, north and up on the meridian of zero
  // longitude are the columns of this matrix.
  const double sine = std::sin(latitude), cosine = std::cos(latitude);
  const Matrix3d local{{0, -sine, cosine}, {1, 0, 0}, {0, cosine, sine}};
  const Vector3d on_earths_axes =
      fictitious_force(1, Vector3d::Zero(), local * v, earth_rate * Vector3d::UnitZ(), Vector3d::Zero());
  CHECK(agrees(a, local.transpose() * on_earths_axes, 1e-14));

  // It does no work, and in the north a level motion is pushed to its right.
  CHECK(agrees(a.dot(v), 0.0, 1e-17, 1));
  const Vector3d level(3, 4, 0), right(4, -3, 0);
  CHECK(coriolis_acceleration(level, latitude, earth_rate).dot(right) > 0);
  CHECK(coriolis_acceleration(level, -latitude, earth_rate).dot(right) < 0);

  Printed page("east north up");
  page.line("v = {} m/s east, north, up", row(v));
  page.line("a = {} m/s²", row(a, "{:.6e}"));
}
//! [east north up]

//! [special latitudes]
TEST_CASE("At the poles, on the equator and along the Earth's axis the Coriolis acceleration is simple") {
  const Vector3d v(30, -20, 10);
  // At the pole Ω points up: no vertical part, and vertical motion feels nothing.
  CHECK(agrees(coriolis_acceleration(v, pi / 2, earth_rate), 2 * earth_rate * Vector3d(-20, -30, 0), 1e-14));
  CHECK(agrees(coriolis_acceleration(v, -pi / 2, earth_rate), 2 * earth_rate * Vector3d(20, 30, 0), 1e-14));
  // On the equator Ω points north: motion to the east lifts, motion up drifts west, motion north feels nothing.
  CHECK(agrees(coriolis_acceleration(v, 0, earth_rate), 2 * earth_rate * Vector3d(-10, 0, 30), 1e-14));
  // Along the axis nothing happens at any latitude.
  for (const double latitude : {-1.2, 1e-8, 0.7, pi / 2 - 1e-8}) {
    const Vector3d along(0, std::cos(latitude), std::sin(latitude));
    CHECK(agrees(coriolis_acceleration(30 * along, latitude, earth_rate), Vector3d::Zero(), 1e-15, earth_rate));
  }
  CHECK(agrees(coriolis_acceleration(Vector3d::Zero(), 0.7, earth_rate), Vector3d::Zero(), 0.0, 1));

  Printed page("special latitudes");
  page.line("30 m/s to the east on the equator: lighter by {:.4e} m/s²",
            coriolis_acceleration({30, 0, 0}, 0, earth_rate).z());
}
//! [special latitudes]

//! [fall]
TEST_CASE("A stone dropped from a tower lands to the east, and not by Ωht") {
  const double h = 110, latitude = 40 * degree, g = 9.81;
  const double t = std::sqrt(2 * h / g);

  const double east = eastward_deflection(h, latitude, g, earth_rate);
  CHECK(agrees(east, 0.01939928567, 1e-9));

  // The equations of motion with the Coriolis acceleration in full. What first order leaves out is of relative size
  // (Ωt)², a few parts in a hundred million.
  const Motion landed = moved({{0, 0, h}, Vector3d::Zero()}, t, [&](const Vector3d&, const Vector3d& v) -> Vector3d {
    return coriolis_acceleration(v, latitude, earth_rate) - g * Vector3d::UnitZ();
  });
  CHECK(agrees(landed.r.x(), east, 1e-6));

  // South of the equator it is east too.
  CHECK(agrees(eastward_deflection(h, -latitude, g, earth_rate), east, 1e-15));

  // A popular wrong turn: "the top is faster by Ωh cos λ, and keeps this speed for the time t" gives half as much
  // again.
  const double popular = earth_rate * h * std::cos(latitude) * t;
  CHECK(agrees(popular, 1.5 * east, 1e-14));

  Printed page("fall");
  page.line("time of the fall        {:.4f} s", t);
  page.line("first order             {:.6f} mm", 1e3 * east);
  page.line("integrated in full      {:.6f} mm", 1e3 * landed.r.x());
  page.line("popular but wrong, Ωht  {:.6f} mm", 1e3 * popular);
}
//! [fall]

//! [seen from outside]
TEST_CASE("Seen from outside the stone is on an orbit, and lands where the Coriolis force says") {
  // On the equator of a round Earth, without any turning frame: Kepler's problem from the top of the tower.
  const double h = 110, R = 6.378e6, GM = 3.986e14;
  const double top = R + h;
  const double momentum = earth_rate * top * top;               // angular momentum per mass, conserved
  const double g = GM / (R * R) - earth_rate * earth_rate * R;  // what a plumb line at the foot feels

  // How far the stone gets ahead of the tower: ∫ (L/r² − Ω) dt, written over the path r = top − h s² so that nothing
  // is singular at the start, and nothing is lost in differences of nearly equal numbers.
  const double ahead = boost::math::quadrature::gauss<double, 15>::integrate(
      [&](double s) {
        const double r = top - h * s * s;
        const double speed_per_s =
            std::sqrt((2 * GM - momentum * momentum * (top + r) / (top * r)) / (top * r));  // |dr/dt| / (√h s)
        const double seconds = 2 * std::sqrt(h) / speed_per_s;
        return earth_rate * h * s * s * (top + r) / (r * r) * seconds;
      },
      0.0, 1.0);

  // What the formula leaves out is of relative size h/R.
  const double east = eastward_deflection(h, 0, g, earth_rate);
  CHECK(agrees(R * ahead, east, 1e-4));

  Printed page("seen from outside");
  page.line("Coriolis force, first order  {:.5f} mm", 1e3 * east);
  page.line("orbit, angular momentum      {:.5f} mm", 1e3 * R * ahead);
}
//! [seen from outside]

//! [reich]
TEST_CASE("V39 Reich 1831: 106 stones down a mine shaft of 158.5 m") {
  // Freiberg, 50°53′12.5″ north. From "Ferdinand Reich" on Wikipedia: calculated at the time 27.5 mm, observed 28.4 mm.
  const double ours = 1e3 * eastward_deflection(158.5, from_arc(50, 53, 12.5), 9.811, earth_rate);

  CHECK(agrees(ours, 27.6, 0.01));
  CHECK(agrees(ours, 27.5, 0.01));  // the theory that Reich's contemporaries printed
  CHECK(agrees(ours, 28.4, 0.05));  // what he saw

  // The motion in full agrees, so it is not the first order that separates theory and observation.
  const double t = std::sqrt(2 * 158.5 / 9.811);
  const Motion landed =
      moved({Vector3d::Zero(), Vector3d::Zero()}, t, [](const Vector3d&, const Vector3d& v) -> Vector3d {
        return coriolis_acceleration(v, from_arc(50, 53, 12.5), earth_rate) - 9.811 * Vector3d::UnitZ();
      });
  CHECK(agrees(1e3 * landed.r.x(), ours, 1e-6));

  Printed page("V39");
  page.line("V39 | 27.6 mm | {:.3f} mm | 1 %", ours);
}
//! [reich]

//! [tower]
TEST_CASE("V43 A tower of 110 m: 45° hides an exchange of sine and cosine, 40° does not") {
  const auto millimetres = [](double latitude) { return 1e3 * eastward_deflection(110, latitude, 9.81, earth_rate); };

  // The expected values have five digits: they agree when the difference is below half a unit of the last one.
  CHECK(agrees(millimetres(45 * degree), 17.907, 0.0005, 1.0));
  CHECK(agrees(millimetres(40 * degree), 19.399, 0.0005, 1.0));
  // In closed form, with both latitudes from one number: ⅓ Ω √(8h³/g).
  const double on_equator = 1e3 * earth_rate * std::sqrt(8 * 110.0 * 110 * 110 / 9.81) / 3;
  CHECK(agrees(millimetres(45 * degree), on_equator * std::sqrt(0.5), 1e-14));
  CHECK(agrees(millimetres(40 * degree), on_equator * std::cos(40 * degree), 1e-14));

  // With the sine instead, nothing changes at 45°, and much at 40°.
  CHECK(agrees(millimetres(45 * degree), on_equator * std::sin(45 * degree), 1e-14));
  CHECK(std::abs(millimetres(40 * degree) - on_equator * std::sin(40 * degree)) > 3);

  Printed page("V43");
  page.line("V43 | 17.907 mm, 19.399 mm | {:.4f} mm, {:.4f} mm | 0.0005 mm", millimetres(45 * degree),
            millimetres(40 * degree));
}
//! [tower]

//! [foucault]
TEST_CASE("Foucault's pendulum turns once in a sidereal day divided by sin λ") {
  const double latitude = 48.8462 * degree;  // the Panthéon in Paris
  const double period = foucault_period(latitude, sidereal_day);
  CHECK(agrees(period, 114435.981, 1e-8));

  // The pendulum itself, for small swings: a spring towards the plumb line and the Coriolis acceleration. It is let go
  // as one does it with a burning thread: at rest on the floor.
  const double omega_swing = std::sqrt(9.81 / 67);
  const double swings = 219;  // about an hour
  const double time = swings * 2 * pi / omega_swing;
  const Motion bob = moved({{6, 0, 0}, Vector3d::Zero()}, time, [&](const Vector3d& r, const Vector3d& v) -> Vector3d {
    Vector3d a = coriolis_acceleration(v, latitude, earth_rate) - omega_swing * omega_swing * r;
    a.z() = 0;  // the string holds the bob at its height
    return a;
  });
  const double turned_by = std::atan2(bob.r.y(), bob.r.x());

  // Clockwise in the north. Let go from rest on the floor, the bob passes the centre at a distance, and the turn is
  // still 2π times the part of the period that has gone by.
  CHECK(turned_by < 0);
  CHECK(agrees(-turned_by, 2 * pi * time / period, 1e-5));

  // At the pole it takes one sidereal day, at 30° two.
  CHECK(agrees(foucault_period(pi / 2, sidereal_day), sidereal_day, 1e-15));
  CHECK(agrees(foucault_period(30 * degree, sidereal_day), 2 * sidereal_day, 1e-14));

  Printed page("foucault");
  page.line("a full turn             {:.3f} s = {:.3f} h", period, period / 3600);
  page.line("simulated for {:.4f} h: {:.5f}°", time / 3600, -turned_by / degree);
  page.line("by the formula:         {:.5f}°", 360 * time / period);
}
//! [foucault]

//! [parallel transport]
TEST_CASE("The pendulum's turn is geometry: a direction carried round a circle of latitude comes back turned") {
  // Carry a direction eastwards round the circle of latitude in small steps, each by the smallest turn that takes the
  // old "up" to the new one, so that it never turns about "up" itself. No dynamics at all.
  const double latitude = 48.8462 * degree;
  const int steps = 20000;
  const auto east_at = [](double longitude) -> Vector3d { return {-std::sin(longitude), std::cos(longitude), 0}; };
  const auto up_at = [&](double longitude) -> Vector3d {
    return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
  };
  Vector3d direction = east_at(0);
  for (int k = 1; k <= steps; ++k) {
    direction =
        Eigen::Quaterniond::FromTwoVectors(up_at(2 * pi * (k - 1) / steps), up_at(2 * pi * k / steps)) * direction;
  }
  // Seen from above, against the east and north of the place.
  const Vector3d north = up_at(0).cross(east_at(0));
  double angle = std::atan2(direction.dot(north), direction.dot(east_at(0)));  // between −π and π
  if (angle > 0) angle -= 2 * pi;                                              // clockwise in the north

  const double per_day = 2 * pi * sidereal_day / foucault_period(latitude, sidereal_day);
  CHECK(agrees(-angle, per_day, 1e-6));

  Printed page("parallel transport");
  page.line("once round, in small steps:      {:.4f}°", -angle / degree);
  page.line("the pendulum in a sidereal day:  {:.4f}°", per_day / degree);
}
//! [parallel transport]

//! [paris]
TEST_CASE("V44 Foucault in Paris: the numbers of the newspapers") {
  // The Irish Times and the travel page tripown print 272° a day, 11° an hour, and 16.5 s for one swing of 67 m.
  const double period = foucault_period(48.8462 * degree, sidereal_day);
  const double hours = period / 3600;
  const double per_hour = 360 / hours;

  CHECK(agrees(hours, 31.788, 0.005));
  CHECK(agrees(per_hour, 11.325, 0.005));
  CHECK(agrees(24 * per_hour, 271.8, 0.005));
  CHECK(agrees(2 * pi * std::sqrt(67 / 9.81), 16.42, 0.005));
  CHECK(agrees(2 * pi * std::sqrt(67 / 9.81), 16.5, 0.005));

  Printed page("V44");
  page.line(
      "V44 | 31.788 h, 11.325°/h, 271.8° in 24 h, 16.42 s | {:.3f} h, {:.3f}°/h, {:.1f}° in 24 h, {:.2f} s | 0.5 %",
      hours, per_hour, 24 * per_hour, 2 * pi * std::sqrt(67 / 9.81));
}
//! [paris]

//! [paris gun]
TEST_CASE("V46 The Paris gun: a shell that flies for three minutes drifts by a kilometre") {
  // 120 km in about 176 s towards azimuth 232°, from 49.5° north. Scientific American speaks of "about half a mile";
  // that is an order of magnitude, not a measurement.
  const double latitude = 49.5 * degree, azimuth = 232 * degree, range = 120e3, time = 176, g = 9.81;
  const double half_a_mile = 804.672;

  const double level_drift = earth_rate * std::sin(latitude) * range * time;
  CHECK(agrees(level_drift, 1170, 0.005));
  CHECK(level_drift < 2 * half_a_mile);
  CHECK(level_drift > half_a_mile / 2);

  // The formula counts the level part of the velocity and the vertical part of Ω. Both are integrated here.
  const Vector3d forward(std::sin(azimuth), std::cos(azimuth), 0);
  const Vector3d right(std::cos(azimuth), -std::sin(azimuth), 0);
  const auto drift = [&](const Vector3d& start, double gravity) {
    return moved({Vector3d::Zero(), start}, time,
                 [&](const Vector3d&, const Vector3d& v) -> Vector3d {
                   return coriolis_acceleration(v, latitude, earth_rate) - gravity * Vector3d::UnitZ();
                 })
        .r.dot(right);
  };
  CHECK(agrees(drift(range / time * forward, 0), level_drift, 0.005));

  // A shell in empty space over a flat Earth also climbs to a great height and falls again, and the northward part of
  // Ω then drives it to the west.
  const double in_full = drift(range / time * forward + g * time / 2 * Vector3d::UnitZ(), g);
  CHECK(in_full > level_drift);
  CHECK(in_full < 2 * half_a_mile);

  Printed page("V46");
  page.line("V46 | about half a mile, 0.8 km | {:.2f} km | factor 2", level_drift / 1e3);
}
//! [paris gun]

//! [same in every attitude]
TEST_CASE("The law does not care how the axes stand: at the angle 0, 1e-8, near half a turn and at half a turn") {
  const Vector3d n = Vector3d(2, -1, 2).normalized();
  const Vector3d a = inertial_acceleration(example_a, example_v, example_r, example_omega, example_alpha);
  const Vector3d force = fictitious_force(2, example_r, example_v, example_omega, example_alpha);

  for (const double angle : {0.0, 1e-8, 0.7, pi - 1e-8, pi}) {
    CAPTURE(angle);
    const Matrix3d A = rotated_basis(Matrix3d::Identity(), n, angle);
    CHECK(
        agrees(inertial_acceleration(A * example_a, A * example_v, A * example_r, A * example_omega, A * example_alpha),
               A * a, 1e-14));
    CHECK(agrees(fictitious_force(2, A * example_r, A * example_v, A * example_omega, A * example_alpha), A * force,
                 1e-14));
  }
}

TEST_CASE("Without rotation there is no fictitious force, and with almost none there is the Coriolis force first") {
  const Vector3d zero = Vector3d::Zero();
  CHECK(agrees(fictitious_force(2, example_r, example_v, zero, zero), zero, 0.0, 1));
  CHECK(agrees(inertial_acceleration(example_a, example_v, example_r, zero, zero), example_a, 0.0));
  // The Coriolis force is of first order in ω and the centrifugal force of second: at 1e-8 it is all that one sees, and
  // what is left over is the other one, not rounding.
  const Vector3d slow = 1e-8 * example_omega;
  const Vector3d coriolis = -4 * slow.cross(example_v);
  const Vector3d force = fictitious_force(2, example_r, example_v, slow, zero);
  CHECK(agrees(force, coriolis, 2e-7));
  CHECK(agrees(force - coriolis, -2 * slow.cross(slow.cross(example_r)), 1e-8));
  // On the axis, and at rest there, nothing pulls.
  CHECK(agrees(fictitious_force(2, 3 * example_omega, zero, example_omega, zero), zero, 1e-15, 1));

  CHECK(agrees(eastward_deflection(0, 0.7, 9.81, earth_rate), 0.0, 0.0, 1));
  CHECK(agrees(eastward_deflection(110, pi / 2, 9.81, earth_rate), 0.0, 1e-15, 0.02));

  Printed page("hard arguments");
  page.line("ω = 1e-8 of the example's: force {} N", row(force, "{:.3e}"));
}
//! [same in every attitude]
