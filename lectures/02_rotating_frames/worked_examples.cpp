// Worked examples of lecture 02. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/result.hpp"

#include <rigid/frame_derivatives.hpp>
#include <rigid/rotating_frames.hpp>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/numeric/odeint.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

using namespace rigid;
using workbook::agrees;
using workbook::result;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
constexpr double Omega_earth = 7.292115e-5;  // rad/s
constexpr double R_earth = 6.371e6;          // m
constexpr double g = 9.81;                   // m/s²
const Vector3d none = Vector3d::Zero(), up = Vector3d::UnitZ();

// A motion in which nothing is special.
const Vector3d some_a(0.1, 0.2, 0.3), some_v(0.4, -0.3, 0.6), some_r(1, 2, -1);
const Vector3d some_omega(0.3, -0.2, 0.5), some_alpha(0.05, 0.1, -0.04);

/// A frame that spins about an axis while that axis rotates about another; ω and α are known in closed form.
struct SpinningAndPrecessing {
  Vector3d spin{0.7, -0.4, 1.1};
  Vector3d precession{0.3, 0.5, -0.2};

  Vector3d spin_now(double t) const { return rotated_basis(Matrix3d::Identity(), precession, t) * spin; }
  Matrix3d basis(double t) const { return rotated_basis(rotated_basis(Matrix3d::Identity(), spin, t), precession, t); }
  Vector3d omega(double t) const { return precession + spin_now(t); }
  Vector3d alpha(double t) const { return precession.cross(spin_now(t)); }
};

/// A path in the moving frame, with its derivatives there.
Vector3d path(double t) { return {std::cos(t), 0.5 * t * t, std::exp(-t)}; }
Vector3d path_velocity(double t) { return {-std::sin(t), t, -std::exp(-t)}; }
Vector3d path_acceleration(double t) { return {-std::cos(t), 1, std::exp(-t)}; }

/// Derivatives by five points: their errors are of fourth order in the step.
template <class Function>
Vector3d derivative(const Function& f, double t) {
  const double h = 1e-3;
  return (f(t - 2 * h) - 8 * f(t - h) + 8 * f(t + h) - f(t + 2 * h)) / (12 * h);
}
template <class Function>
Vector3d second_derivative(const Function& f, double t) {
  const double h = 5e-3;
  return (-f(t - 2 * h) + 16 * f(t - h) - 30 * f(t) + 16 * f(t + h) - f(t + 2 * h)) / (12 * h * h);
}

struct Motion {
  Vector3d r, v;
};

/// Position and velocity after a time, integrated from an acceleration that depends on both.
Motion moved(const Motion& start, double time,
             const std::function<Vector3d(const Vector3d& r, const Vector3d& v)>& acceleration) {
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

double integral(const std::function<double(double)>& f, double from, double to) {
  return boost::math::quadrature::gauss<double, 15>::integrate(f, from, to);
}

}  // namespace

//! [puck]
TEST_CASE("puck: A straight line, seen by somebody who rotates") {
  //! [puck in brief]
  const Vector3d omega(0, 0, 1);                 // rad/s: the turntable
  const Vector3d r0(-1, 0, 0), v0(0.5, 0.1, 0);  // m, m/s: the puck
  const auto fictitious = [&](const Vector3d& r, const Vector3d& v) {
    return fictitious_force(1, r, v, omega, Vector3d::Zero());
  };
  const double t = 3;  // s
  const Matrix3d back = rotated_basis(Matrix3d::Identity(), omega, -t);
  const Vector3d rotated_back = back * (r0 + v0 * t);
  const Vector3d predicted = moved({r0, v0 - omega.cross(r0)}, t, fictitious).r;
  //! [puck in brief]

  CHECK(agrees(predicted, rotated_back, 1e-11));
  // Without the factor 2 of the Coriolis force.
  const Vector3d without_two = moved({r0, v0 - omega.cross(r0)}, t, [&](const Vector3d& r, const Vector3d& v) {
                                 return fictitious(r, 0.5 * v);
                               }).r;
  CHECK((without_two - rotated_back).norm() > 1);

  result(R"(\vec r_\mathrm{rotated})", rotated_back, "m", "the straight line rotated back", 4);
  result(R"(\vec r_\mathrm{predicted})", Vector3d(predicted.x(), predicted.y(), 0), "m", "from the fictitious forces",
         4);
  result(R"(\vec r_\mathrm{without})", Vector3d(without_two.x(), without_two.y(), 0), "m",
         "without the factor 2 in the Coriolis force: another place altogether", 4);
}
//! [puck]

//! [terms]
TEST_CASE("terms: A child walks outwards on a merry-go-round that is being braked") {
  //! [terms in brief]
  const Vector3d omega(0, 0, 2 * pi / 12), alpha(0, 0, -0.05);
  const Vector3d r(2, 0, 0), v(0.5, 0, 0);  // m, m/s, as the child sees it
  const Vector3d coriolis = 2 * omega.cross(v);
  const Vector3d euler = alpha.cross(r);
  const Vector3d centripetal = omega.cross(omega.cross(r));
  const Vector3d a = inertial_acceleration(Vector3d::Zero(), v, r, omega, alpha);
  //! [terms in brief]

  CHECK(agrees(a, coriolis + euler + centripetal, 1e-14));
  // Finite differences of the positions that an inertial observer notes, for a frame and a path in general motion.
  const SpinningAndPrecessing frame;
  for (const double t : {-1.3, 0.0, 0.8, 2.4}) {
    const Vector3d measured = second_derivative([&](double s) -> Vector3d { return frame.basis(s) * path(s); }, t);
    const Matrix3d A = frame.basis(t);
    const Vector3d omega_t = frame.omega(t);
    CHECK(agrees(
        inertial_acceleration(A * path_acceleration(t), A * path_velocity(t), A * path(t), omega_t, frame.alpha(t)),
        measured, 1e-8));
    // The rate of ω is the same in both frames.
    CHECK(agrees(derivative([&](double s) { return frame.omega(s); }, t), frame.alpha(t), 1e-10));
    CHECK(agrees(A * derivative([&](double s) -> Vector3d { return frame.basis(s).transpose() * frame.omega(s); }, t),
                 frame.alpha(t), 1e-10));
  }
  // The transport theorem twice: first to the position, then to the velocity, whose rate in the frame is a + α×r + ω×v.
  const Vector3d velocity = inertial_rate(some_v, some_omega, some_r);
  const Vector3d seen = some_a + some_alpha.cross(some_r) + some_omega.cross(some_v);
  const Vector3d twice = inertial_rate(seen, some_omega, velocity);
  CHECK(agrees(twice, inertial_acceleration(some_a, some_v, some_r, some_omega, some_alpha), 1e-14));
  CHECK(agrees(twice, Vector3d(-0.42, -0.39, 0.36), 1e-14));

  result(R"(2\,\vec\omega\times\vec v_\bodyframe)", coriolis, "m/s²", "to the left of the walk", 4);
  result(R"(\dot{\vec\omega}\times\vec r)", euler, "m/s²", "because the merry-go-round slows down");
  result(R"(\vec\omega\times(\vec\omega\times\vec r))", centripetal, "m/s²", "towards the axis", 4);
  result(R"(\vec a_\inertialframe)", a, "m/s²", "which the friction of the shoes must supply", 4);
}
//! [terms]

//! [brackets]
TEST_CASE("brackets: A lamp that hangs above the floor of the merry-go-round") {
  //! [brackets in brief]
  const Vector3d omega(0, 0, 2 * pi / 12), r(2, 0, 3);  // rad/s, m
  const Vector3d from_the_left = omega.cross(omega).cross(r);
  const Vector3d from_the_right = omega.cross(omega.cross(r));
  //! [brackets in brief]

  CHECK(agrees(from_the_left, none, 0, 1));
  // −ω² times the part of r across the axis, also for an axis in a general direction.
  const Vector3d& w = some_omega;
  const Vector3d across = some_r - w * w.dot(some_r) / w.squaredNorm();
  CHECK(agrees(w.cross(w.cross(some_r)), -w.squaredNorm() * across, 1e-14));
  CHECK(agrees(from_the_right, Vector3d(-2 * omega.squaredNorm(), 0, 0), 1e-14));

  result(R"(\vec\omega\times(\vec\omega\times\vec r))", from_the_right, "m/s²", "horizontal, towards the axis", 4);
  result(R"(-\omega^2\,\vec r)", -omega.squaredNorm() * r, "m/s²", "towards the origin: something else", 4);
}
//! [brackets]

//! [tree]
TEST_CASE("tree: Seen from a carousel a tree moves on a circle, and the Coriolis force holds it there") {
  //! [tree in brief]
  const Vector3d omega(0, 0, 0.5), r(20, 0, 0);  // rad/s, m
  const Vector3d v = -omega.cross(r);            // the tree is at rest on the ground
  const Vector3d zero = Vector3d::Zero();
  const Vector3d centrifugal = fictitious_force(1, r, zero, omega, zero);
  const Vector3d coriolis = fictitious_force(1, zero, v, omega, zero);
  //! [tree in brief]

  CHECK(agrees(coriolis, -2 * centrifugal, 1e-15));
  CHECK(agrees(centrifugal + coriolis, omega.cross(omega.cross(r)), 1e-15));
  CHECK(agrees(inertial_acceleration(centrifugal + coriolis, v, r, omega, zero), zero, 1e-15, 1));
  // The real force and the fictitious one together make m a_body.
  const Vector3d force = fictitious_force(2, some_r, some_v, some_omega, some_alpha);
  CHECK(agrees(force, Vector3d(1.04, 1.18, -0.12), 1e-14));
  const Vector3d real = 2 * inertial_acceleration(some_a, some_v, some_r, some_omega, some_alpha);
  CHECK(agrees(real + force, 2 * some_a, 1e-14, 1));
  // At rest in a steady frame only the centrifugal force is left, and it points away from the axis.
  const Vector3d n = some_omega.normalized(), from_axis = some_r - n * n.dot(some_r);
  CHECK(agrees(fictitious_force(2, some_r, zero, some_omega, zero), 2 * some_omega.squaredNorm() * from_axis, 1e-14));

  result(R"(-\vec\omega\times(\vec\omega\times\vec r))", centrifugal, "N/kg", "outwards");
  result(R"(-2\,\vec\omega\times\vec v_\bodyframe)", coriolis, "N/kg", "inwards, twice as large");
}
//! [tree]

//! [attitudes]
TEST_CASE("attitudes: The law is the same on all axes, and fails at no special value") {
  const Vector3d a = inertial_acceleration(some_a, some_v, some_r, some_omega, some_alpha);
  const Vector3d force = fictitious_force(2, some_r, some_v, some_omega, some_alpha);
  for (const double angle : {0.0, 1e-8, 0.7, pi - 1e-8, pi}) {
    CAPTURE(angle);
    const Matrix3d A = rotated_basis(Matrix3d::Identity(), Vector3d(2, -1, 2).normalized(), angle);
    CHECK(agrees(inertial_acceleration(A * some_a, A * some_v, A * some_r, A * some_omega, A * some_alpha), A * a,
                 1e-14));
    CHECK(agrees(fictitious_force(2, A * some_r, A * some_v, A * some_omega, A * some_alpha), A * force, 1e-14));
  }
  CHECK(agrees(fictitious_force(2, some_r, some_v, none, none), none, 0.0, 1));
  CHECK(agrees(inertial_acceleration(some_a, some_v, some_r, none, none), some_a, 0.0));
  // The Coriolis force is of first order in ω and the centrifugal force of second: at 1e-8 it is all that is seen, and
  // what is left over is the other one, not rounding.
  const Vector3d slow = 1e-8 * some_omega, coriolis = -4 * slow.cross(some_v);
  const Vector3d both = fictitious_force(2, some_r, some_v, slow, none);
  CHECK(agrees(both, coriolis, 2e-7));
  CHECK(agrees(both - coriolis, -2 * slow.cross(slow.cross(some_r)), 1e-8));
  // On the axis, and at rest there, nothing pulls.
  CHECK(agrees(fictitious_force(2, 3 * some_omega, none, some_omega, none), none, 1e-15, 1));
  CHECK(agrees(eastward_deflection(0, 0.7, g, Omega_earth), 0.0, 0.0, 1));
  CHECK(agrees(eastward_deflection(110, pi / 2, g, Omega_earth), 0.0, 1e-15, 0.02));
}
//! [attitudes]

//! [jacobi]
TEST_CASE("jacobi: The puck's energy on the turntable, with the centrifugal potential") {
  const Vector3d omega(0, 0, 1), r0(-1, 0, 0), v0(0.5, 0.1, 0);  // rad/s, m, m/s
  //! [jacobi in brief]
  const auto H = [&](const Motion& puck) {  // for each kg, J/kg
    return 0.5 * puck.v.squaredNorm() - 0.5 * omega.cross(puck.r).squaredNorm();
  };
  const Motion start{r0, v0 - omega.cross(r0)};
  const Motion end = moved(start, 3, [&](const Vector3d& r, const Vector3d& v) {
    return fictitious_force(1, r, v, omega, Vector3d::Zero());
  });
  //! [jacobi in brief]

  CHECK(agrees(H(end), H(start), 1e-11));
  // H is the inertial energy less ω · L.
  CHECK(agrees(H(start), 0.5 * v0.squaredNorm() - omega.dot(r0.cross(v0)), 1e-14));
  result("H(0)", H(start), "J/kg", "at the start");
  result(R"(H(3\,\mathrm s))", H(end), "J/kg",
         R"(while \(\tfrac12 v_\bodyframe^2\) has changed from )" +
             fmt::format("{:.3f} to {:.3f} J/kg", 0.5 * start.v.squaredNorm(), 0.5 * end.v.squaredNorm()));
}
//! [jacobi]

//! [larmor]
TEST_CASE("larmor: In a weak magnetic field every orbit of an electron precesses") {
  //! [larmor in brief]
  const double e = 1.602176634e-19, m = 9.1093837015e-31;  // C, kg: an electron
  const double B = 1;                                      // T
  const double larmor = e * B / (2 * m);                   // rad/s
  //! [larmor in brief]

  // A charge q = −1 of mass 1 on a spring in a field along z: in the frame that rotates with −qB/2m the orbit is that
  // of a spring which is stiffer by (qB/2m)² across the field.
  const double field = 0.02, q = -1, spring = 1;
  const Vector3d omega = -q * field / 2 * up;
  const Vector3d start(1, 0, 0.3), velocity(0.1, 0.4, 0.2);
  const Vector3d lab = moved({start, velocity}, 40, [&](const Vector3d& r, const Vector3d& v) -> Vector3d {
                         return -spring * r + q * v.cross(field * up);
                       }).r;
  const Vector3d rotating =
      moved({start, velocity - omega.cross(start)}, 40, [&](const Vector3d& r, const Vector3d&) -> Vector3d {
        return -spring * r + omega.cross(omega.cross(r));
      }).r;
  CHECK(agrees(rotated_basis(Matrix3d::Identity(), omega, 40) * rotating, lab, 1e-10));

  result(R"(\omega_\mathrm L/2\pi)", larmor / (2 * pi) / 1e9, "GHz", "in a field of one tesla", 5);
}
//! [larmor]

//! [train]
TEST_CASE("train: A train at 300 km/h is pushed to the right") {
  //! [train in brief]
  const Vector3d v(0, 300 / 3.6, 0);  // m/s: east, north, up
  const Vector3d a = coriolis_acceleration(v, 50 * degree, Omega_earth);
  const Vector3d force = 400e3 * a;  // N: a train of 400 t
  //! [train in brief]

  // On the Earth's own axes, z through the north pole, Ω has one component. East, north and up on the meridian of zero
  // longitude are the columns of this matrix.
  for (const double latitude : {40 * degree, -70 * degree, 0.0, pi / 2}) {
    const Vector3d flight(30, -20, 10);
    const double sine = std::sin(latitude), cosine = std::cos(latitude);
    const Matrix3d local{{0, -sine, cosine}, {1, 0, 0}, {0, cosine, sine}};
    const Vector3d on_earths_axes = fictitious_force(1, none, local * flight, Omega_earth * up, none);
    const Vector3d there = coriolis_acceleration(flight, latitude, Omega_earth);
    CHECK(agrees(there, local.transpose() * on_earths_axes, 1e-14));
    CHECK(agrees(there.dot(flight), 0.0, 1e-16, 1));  // no work
    // Along the Earth's axis nothing happens.
    CHECK(agrees(coriolis_acceleration(30 * Vector3d(0, cosine, sine), latitude, Omega_earth), none, 1e-15,
                 30 * Omega_earth));
  }
  CHECK(agrees(coriolis_acceleration({30, -20, 10}, 40 * degree, Omega_earth),
               Vector3d(-0.002992129303, -0.002812368702, 0.003351650505), 1e-9));
  // Level motion is pushed to its right in the north, to its left in the south.
  const Vector3d level(3, 4, 0), right(4, -3, 0);
  CHECK(coriolis_acceleration(level, 40 * degree, Omega_earth).dot(right) > 0);
  CHECK(coriolis_acceleration(level, -40 * degree, Omega_earth).dot(right) < 0);
  // At the poles there is no vertical part; on the equator motion to the east lifts, and motion up drifts west.
  CHECK(agrees(coriolis_acceleration({30, -20, 10}, pi / 2, Omega_earth), 2 * Omega_earth * Vector3d(-20, -30, 0),
               1e-14));
  CHECK(agrees(coriolis_acceleration({30, -20, 10}, 0, Omega_earth), 2 * Omega_earth * Vector3d(-10, 0, 30), 1e-14));

  result("a_\\mathrm{east}", a.x(), "m/s²", "to the right of a train that goes north", 4);
  result("F_\\mathrm{east}", force.x() / 1e3, "kN", "about a thousandth of its weight", 3);
}
//! [train]

//! [plumb]
TEST_CASE("plumb: A plumb line does not point to the centre of the Earth") {
  //! [plumb in brief]
  const double latitude = 45 * degree;
  const Vector3d axis(0, std::cos(latitude), std::sin(latitude));  // east, north, up
  const Vector3d r(0, 0, R_earth), zero = Vector3d::Zero();
  const Vector3d centrifugal = fictitious_force(1, r, zero, Omega_earth * axis, zero);
  const Vector3d effective = Vector3d(0, 0, -9.82) + centrifugal;  // N/kg
  const double deflection = std::atan2(-effective.y(), -effective.z());
  //! [plumb in brief]

  const double on_equator = Omega_earth * Omega_earth * R_earth;
  CHECK(agrees(centrifugal, on_equator / 2 * Vector3d(0, -1, 1), 1e-14));
  CHECK(agrees(deflection, on_equator / 2 / (9.82 - on_equator / 2), 1e-5));
  result(R"(\Omega_\mathrm E^2 R_\mathrm E)", on_equator, "m/s²", "the centrifugal acceleration on the equator", 3);
  result(R"(\angle(\vec g_\mathrm{eff},\vec g))", deflection / degree * 60, "minutes of arc",
         "to the south, at a latitude of 45°", 3);
}
//! [plumb]

//! [fall]
TEST_CASE("fall: A stone from a tower of 110 m lands to the east of the plumb line") {
  //! [fall in brief]
  const double h = 110, latitude = 40 * degree;  // m
  const double t = std::sqrt(2 * h / g);
  const double d = eastward_deflection(h, latitude, g, Omega_earth);

  const auto acceleration = [&](const Vector3d&, const Vector3d& v) -> Vector3d {
    return coriolis_acceleration(v, latitude, Omega_earth) - g * Vector3d::UnitZ();
  };
  const Motion landed = moved({{0, 0, h}, {0, 0, 0}}, t, acceleration);
  const double popular = Omega_earth * h * std::cos(latitude) * t;
  //! [fall in brief]

  CHECK(agrees(d, 0.01939928567, 1e-9));
  CHECK(agrees(landed.r.x(), d, 1e-6));  // first order leaves out (Ωt)², which is 1.2e-7
  CHECK(agrees(popular, 1.5 * d, 1e-14));
  // South of the equator it is east too.
  CHECK(agrees(eastward_deflection(h, -latitude, g, Omega_earth), d, 1e-15));
  // At 45° an exchange of sine and cosine would not be seen; the value there is 17.907 mm.
  CHECK(agrees(1e3 * eastward_deflection(h, 45 * degree, g, Omega_earth), 17.907, 0.0005, 1));
  // Thrown up to the same height it lands to the west, four times as far.
  const Motion thrown = moved({none, g * t * up}, 2 * t, acceleration);
  CHECK(agrees(thrown.r.x(), -4 * d, 1e-6));

  result("t", t, "s", "of the fall", 4);
  result("d", 1e3 * d, "mm", "to the east, by the formula", 5);
  result(R"(d_\mathrm{full})", 1e3 * landed.r.x(), "mm", "integrated with the whole Coriolis acceleration", 5);
  result(R"(\Omega_\mathrm E h t\cos\lambda)", 1e3 * popular, "mm", "popular and wrong, see below", 5);
}
//! [fall]

//! [orbit]
TEST_CASE("orbit: Seen from outside the stone is on an orbit, and lands where the Coriolis force says") {
  //! [orbit in brief]
  const double h = 110, R = 6.378e6, GM = 3.986e14, top = R + h;
  const double L = Omega_earth * top * top;  // angular momentum per kg
  const double ahead = integral(
      [&](double s) {
        const double r = top - h * s * s;
        const double gained = 2 * GM * (1 / r - 1 / top);  // squared speed
        const double sideways = L * L * (1 / (r * r) - 1 / (top * top));
        return (L / (r * r) - Omega_earth) * 2 * h * s / std::sqrt(gained - sideways);
      },
      0, 1);
  //! [orbit in brief]

  const double g_at_foot = GM / (R * R) - Omega_earth * Omega_earth * R;  // what a plumb line feels
  const double d = eastward_deflection(h, 0, g_at_foot, Omega_earth);
  CHECK(agrees(R * ahead, d, 2 * h / R));

  result(R"(R\,\Delta\varphi)", 1e3 * R * ahead, "mm", "ahead of the tower, from the orbit", 6);
  result("d", 1e3 * d, "mm", R"(by the Coriolis force; the difference is of the order of \(h/R\))", 6);
}
//! [orbit]

//! [reich]
TEST_CASE("reich: Reich's 106 stones in a mine shaft at Freiberg") {
  //! [reich in brief]
  const double h = 158.5;  // m
  const double latitude = (50 + 53 / 60.0 + 12.5 / 3600) * degree;
  const double d = eastward_deflection(h, latitude, 9.811, Omega_earth);
  //! [reich in brief]

  const Motion landed = moved({none, none}, std::sqrt(2 * h / 9.811), [&](auto&, const Vector3d& v) -> Vector3d {
    return coriolis_acceleration(v, latitude, Omega_earth) - 9.811 * up;
  });
  CHECK(agrees(landed.r.x(), d, 1e-6));
  // To the south, by the Coriolis force on the eastward velocity: Ω² g t⁴ sin λ cos λ / 6.
  const double t = std::sqrt(2 * h / 9.811), south = -landed.r.y();
  CHECK(
      agrees(south, std::pow(Omega_earth * t, 2) * 9.811 * t * t * std::sin(latitude) * std::cos(latitude) / 6, 1e-5));

  result("d", 1e3 * d, "mm", "to the east; Reich measured 28.4 mm", 3);
  result(R"(d_\mathrm{south})", 1e3 * south, "mm",
         "by the Coriolis force on the eastward velocity; Reich measured 4.4 mm", 2);
}
//! [reich]

//! [foucault]
TEST_CASE("foucault: The pendulum in the Panthéon") {
  //! [foucault in brief]
  const double latitude = 48.8462 * degree;                // the Panthéon in Paris
  const double P = foucault_period(latitude, 86164.0989);  // s
  const double per_hour = 360 * 3600 / P;                  // degrees
  const double swing = 2 * pi * std::sqrt(67 / g);         // s: a wire of 67 m
  //! [foucault in brief]

  CHECK(agrees(P, 2 * pi / (Omega_earth * std::sin(latitude)), 1e-7));
  CHECK(agrees(foucault_period(pi / 2, 86164.0989), 86164.0989, 1e-15));
  CHECK(agrees(foucault_period(30 * degree, 86164.0989), 2 * 86164.0989, 1e-14));

  result("P", P / 3600, "h", "for 360°", 4);
  result(R"(360^\circ/P)", per_hour, "degrees per hour", "clockwise", 4);
  result(R"(24\,\mathrm h\cdot360^\circ/P)", 24 * per_hour, "°", "in 24 hours", 4);
  result(R"(2\pi/\omega_0)", swing, "s", "for one swing there and back", 4);
}
//! [foucault]

//! [rosette]
TEST_CASE("rosette: The exact path of a pendulum that is released at rest on the floor") {
  const double latitude = 48.8462 * degree;  // Paris
  //! [rosette in brief]
  const double a = 3, length = 67;   // m
  const auto zeta = [&](double t) {  // east + i north, m
    const Vector2d place = foucault_path({a, 0}, length, g, latitude, Omega_earth, t);
    return std::complex<double>(place.x(), place.y());
  };
  const double omega_0 = std::sqrt(g / length);
  const double nearest = std::abs(zeta(pi / 2 / omega_0));  // a quarter of a swing after the release
  //! [rosette in brief]

  // The equation of motion, integrated for an hour: a spring towards the plumb line and the Coriolis acceleration; the
  // string holds the bob at its height.
  const double time = 219 * 2 * pi / omega_0;
  const Vector3d bob = moved({{a, 0, 0}, none}, time, [&](const Vector3d& r, const Vector3d& v) -> Vector3d {
                         Vector3d acceleration =
                             coriolis_acceleration(v, latitude, Omega_earth) - omega_0 * omega_0 * r;
                         acceleration.z() = 0;
                         return acceleration;
                       }).r;
  CHECK(agrees(bob.x(), zeta(time).real(), 1e-8));
  CHECK(agrees(bob.y(), zeta(time).imag(), 1e-8));
  // The plane has rotated clockwise by 2π times the part of the period that has passed.
  const double rotated_by = -std::atan2(bob.y(), bob.x());
  CHECK(agrees(rotated_by, 2 * pi * time / foucault_period(latitude, 2 * pi / Omega_earth), 1e-5));
  // By the solution in complex numbers.
  const std::complex<double> i(0, 1);
  const double Omega_z = Omega_earth * std::sin(latitude), omega_1 = std::hypot(omega_0, Omega_z);
  for (const double t : {1.0, 100.0, time})
    CHECK(std::abs(zeta(t) - a * std::exp(-i * Omega_z * t) *
                                 (std::cos(omega_1 * t) + i * Omega_z / omega_1 * std::sin(omega_1 * t))) < 1e-6);
  CHECK(agrees(nearest, a * Omega_z / omega_1, 1e-6));

  result(R"(|\zeta|_{\min})", 1e3 * nearest, "mm", "the distance at which the bob passes the centre", 2);
  result(R"(\text{rotation of the plane})", rotated_by / degree, "°",
         fmt::format("clockwise, after 219 swings ({:.2f} s), by integration", time), 5);
}
//! [rosette]

//! [ellipse]
TEST_CASE("ellipse: How far a pendulum may swing sideways before its own precession is mistaken for the Earth's") {
  const double Omega_z = Omega_earth * std::sin(48.8462 * degree);
  //! [ellipse in brief]
  const auto sideways = [&](double l, double a) {  // m: where 3/8 ω₀ ab/ℓ² equals Ω_z
    return 8 * Omega_z * l * l / (3 * std::sqrt(g / l) * a);
  };
  const double in_the_cellar = sideways(2, 0.3), in_the_dome = sideways(67, 3);
  //! [ellipse in brief]

  // The precession of a pendulum without any rotation of the floor: a point on a sphere, for 50 swings. The axes of the
  // ellipse follow from ζ̇² + ω₀²ζ² = ω₀² (a² − b²) exp(2iφ).
  const double l = 2, a = 0.2, b = 0.02, omega_0 = std::sqrt(g / l), time = 50 * 2 * pi / omega_0;
  const Vector3d gravity = -g * up;
  const Motion bob = moved({{a, 0, -std::sqrt(l * l - a * a)}, {0, omega_0 * b, 0}}, time,
                           [&](const Vector3d& r, const Vector3d& v) -> Vector3d {
                             return gravity - r * (v.squaredNorm() + gravity.dot(r)) / (l * l);
                           });
  const std::complex<double> zeta(bob.r.x(), bob.r.y()), rate(bob.v.x(), bob.v.y());
  const double angle = std::arg(rate * rate + omega_0 * omega_0 * zeta * zeta) / 2;
  CHECK(agrees(angle, 3.0 / 8 * omega_0 * a * b / (l * l) * time, 0.03));

  result(R"(b_{2\,\mathrm m})", 1e3 * in_the_cellar, "mm", "for a wire of 2 m and an amplitude of 0.3 m", 2);
  result(R"(b_{67\,\mathrm m})", in_the_dome, "m", "for 67 m and 3 m", 2);
}
//! [ellipse]

//! [transport]
TEST_CASE("transport: A direction carried round a circle of latitude comes back rotated") {
  const double latitude = 48.8462 * degree;
  const auto up_at = [&](double longitude) -> Vector3d {
    return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
  };
  //! [transport in brief]
  const int steps = 20000;
  Vector3d direction(0, 1, 0);  // east, on the meridian of zero longitude
  for (int k = 0; k < steps; ++k) {
    const Vector3d here = up_at(2 * pi * k / steps);
    const Vector3d next = up_at(2 * pi * (k + 1) / steps);
    const Vector3d turn = here.cross(next);  // its length is the angle, which is small
    direction = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * direction;
  }
  const double solid_angle = 2 * pi * (1 - std::sin(latitude));
  //! [transport in brief]

  // Seen from above, against the east and north of the place.
  const Vector3d east(0, 1, 0), north = up_at(0).cross(east);
  const double angle = std::atan2(direction.dot(north), direction.dot(east));
  CHECK(agrees(angle, solid_angle, 1e-6));
  const double pendulum = 2 * pi * 86164.0989 / foucault_period(latitude, 86164.0989);  // in one rotation of the Earth
  CHECK(agrees(2 * pi - angle, pendulum, 1e-6));

  result(R"(\text{rotation})", angle / degree, "°", "anticlockwise, found by carrying the direction", 5);
  result(R"(2\pi(1-\sin\lambda))", solid_angle / degree, "°",
         fmt::format("which is 360° less {:.2f}°, the pendulum's clockwise angle", pendulum / degree), 5);
}
//! [transport]

//! [gun]
TEST_CASE("gun: A shell that flies for three minutes drifts by more than a kilometre") {
  //! [gun in brief]
  const double latitude = 49.5 * degree, azimuth = 232 * degree;
  const double s = 120e3, t = 176;  // m, s
  const auto drift_of = [&](double range) { return shell_drift(latitude, azimuth, range, t, g, Omega_earth); };
  const double drifted = drift_of(s), climb = drift_of(0), level = drifted - climb;  // without range: climb and fall
  //! [gun in brief]

  const Vector3d forward(std::sin(azimuth), std::cos(azimuth), 0), right(std::cos(azimuth), -std::sin(azimuth), 0);
  const auto drift = [&](const Vector3d& start, double gravity) {
    return moved({none, start}, t,
                 [&](auto&, const Vector3d& v) -> Vector3d {
                   return coriolis_acceleration(v, latitude, Omega_earth) - gravity * up;
                 })
        .r.dot(right);
  };
  // What the formulas leave out is of the relative order Ωt, 1 %.
  CHECK(agrees(drift(s / t * forward, 0), level, 0.01));
  CHECK(agrees(drift(s / t * forward + g * t / 2 * up, g), drifted, 0.01));
  // A shot to the north lands without drift where tan λ = g t²/(6R).
  const double there = std::atan(g * t * t / (6 * s));
  CHECK(agrees(there / degree, 22.88, 0.005, 1));
  CHECK(agrees(std::sin(there) * s, std::cos(there) * g * t * t / 6, 1e-14));

  result(R"(d_\mathrm{level})", level, "m", "to the right, by the level motion", 4);
  result(R"(d_\mathrm{climb})", climb, "m", "to the right, by climb and fall", 3);
  result("d", drifted, "m", "together", 4);
  result(R"(\lambda_0)", there / degree, "°", "where a shot to the north would land without drift", 4);
}
//! [gun]
