// Worked examples of lecture 05. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/motion.hpp"
#include "lectures/support/result.hpp"

#include <rigid/euler_equations.hpp>
#include <rigid/inertia_tensor.hpp>

#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <cmath>
#include <numbers>
#include <utility>

using namespace rigid;
using workbook::agrees;
using workbook::integrated;
using workbook::Motion;
using workbook::result;
using workbook::result_table;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

/// What the contract asks of an integration, and so all that an example may ask of free_rotation().
constexpr double as_contracted = 1e-6;

/// The tensor of lecture 03's body: four masses, one on each axis and one off all of them.
Matrix3d tensor_of_four_masses() {
  return inertia_of_points(VectorXd{{1, 2, 3, 4}}, Matrix3Xd{{1, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 3, 1}});
}

// The body and the start of all integrations here: kg m², rad/s.
const Vector3d tumbling_body(1, 2, 3), tumbling_start(0.1, 1, 0.1);

// The rate of change of ω under a torque, from the attitude matrix and the laws of motion instead of euler_equations().
Vector3d rate_by_waiting(const Vector3d& I, const Motion& start, const workbook::Torque& torque) {
  const double h = 1e-4 / start.omega.norm();
  return (integrated(I, start, h, torque).omega - integrated(I, start, -h, torque).omega) / (2 * h);
}

}  // namespace

//! [gyroscope]
TEST_CASE("gyroscope: A bicycle wheel that hangs by one end of its axle goes round") {
  //! [gyroscope in brief]
  const double M = 1.5, R = 0.30;     // kg, m: a bicycle wheel, all its mass in the rim
  const double l = 0.12, g = 9.81;    // m from the rope to the wheel, m/s²
  const double spin = 8 * pi;         // four turns per second, rad/s
  const double L = M * R * R * spin;  // along the horizontal axle
  const double precession = M * g * l / L;
  //! [gyroscope in brief]

  // The long way: about the end of the axle, with Euler's equations and the attitude. At the start the axle (axis 3)
  // lies along x, axis 2 is vertical, and the whole goes round with the precession.
  const Vector3d I(M * R * R / 2 + M * l * l, M * R * R / 2 + M * l * l, M * R * R);
  const Motion start{{0, precession, spin}, Matrix3d{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
  const auto gravity = [&](const Motion& now) -> Vector3d {
    return Vector3d(0, 0, l).cross(now.A.transpose() * Vector3d(0, 0, -M * g));
  };
  for (const double t : {0.7, 3.0}) {
    const Vector3d axle = integrated(I, start, t, gravity).A.col(2);
    CHECK(agrees(axle, Vector3d(std::cos(precession * t), std::sin(precession * t), 0), 1e-10));
  }
  CHECK(agrees(euler_equations(I, start.omega, gravity(start)), rate_by_waiting(I, start, gravity), 1e-6));

  result("L", L, "kg m²/s", "along the axle", 4);
  result(R"(\dot\phi)", precession, "rad/s", "the precession", 3);
  result(R"(2\pi/\dot\phi)", 2 * pi / precession, "s", "for one round about the rope", 3);
}
//! [gyroscope]

//! [rate]
TEST_CASE("rate: The rate of L in the inertial frame is what the body sees, plus ω × L") {
  const Matrix3d I = tensor_of_four_masses();
  //! [rate in brief]
  const Vector3d omega(0.3, -0.2, 0.5), omega_rate(0.1, 0.2, -0.3);  // rad/s, rad/s²
  const Vector3d seen_from_body = I * omega_rate;
  const Vector3d carried_along = omega.cross(I * omega);
  const Vector3d L_rate = angular_momentum_rate(I, omega, omega_rate);
  //! [rate in brief]

  // Let the body rotate for a short time h either way, and look at L from the inertial frame.
  const auto L_inertial = [&](double h) -> Vector3d {
    const Vector3d rotation = h * omega + h * h / 2 * omega_rate;  // axis times angle, right to second order in h
    return Eigen::AngleAxisd(rotation.norm(), rotation.normalized()) * (I * (omega + h * omega_rate));
  };
  const double h = 1e-4;
  CHECK(agrees(L_rate, (L_inertial(h) - L_inertial(-h)) / (2 * h), 1e-7));
  CHECK(agrees(L_rate, seen_from_body + carried_along, 1e-14));
  CHECK(agrees(L_rate, Vector3d(8.28, 11.42, -7.08), 1e-14));

  // On principal axes, as on the slides: I_i dω_i/dt, and the product of the two other components of ω.
  const Vector3d J(1, 2, 3);
  const Vector3d slides(J[0] * omega_rate[0] + omega[1] * omega[2] * (J[2] - J[1]),
                        J[1] * omega_rate[1] + omega[2] * omega[0] * (J[0] - J[2]),
                        J[2] * omega_rate[2] + omega[0] * omega[1] * (J[1] - J[0]));
  CHECK(agrees(angular_momentum_rate(J.asDiagonal(), omega, omega_rate), slides, 1e-14));

  result(R"(\Inertia\cdot\dot{\vec\omega})", seen_from_body, "N m", "seen from the body");
  result(R"(\vec\omega\times\vec L)", carried_along, "N m", R"(because the axes carry \(\vec L\) along)");
  result(R"(\dot{\vec L})", L_rate, "N m", "in the inertial frame: the torque");
}
//! [rate]

//! [euler]
TEST_CASE("euler: A book that nobody touches changes its angular velocity") {
  //! [euler in brief]
  const Vector3d square = Vector3d(0.24, 0.17, 0.03).cwiseAbs2();  // a book, m²
  const Vector3d I = 0.9 / 12 * (square.sum() - square.array());   // 0.9 kg
  const Vector3d omega(0.5, 10, 0.5);                              // rad/s
  const Vector3d omega_rate = euler_equations(I, omega, Vector3d::Zero());
  //! [euler in brief]

  CHECK(agrees(omega_rate, rate_by_waiting(I, {omega}, {}), 1e-7));
  // Line by line with a torque: I₁ dω₁/dt = τ₁ − ω₂ω₃(I₃ − I₂) = 0.2 + 0.1, and so on.
  const Vector3d torque(0.2, -0.1, 0.3);
  const Vector3d under_torque = euler_equations({1, 2, 3}, {0.3, -0.2, 0.5}, torque);
  CHECK(agrees(under_torque, Vector3d(0.3, 0.1, 0.12), 1e-14));
  // Put back into the rate of L, it returns the torque.
  CHECK(agrees(angular_momentum_rate(Vector3d(1, 2, 3).asDiagonal(), {0.3, -0.2, 0.5}, under_torque), torque, 1e-14));

  result("(I_1, I_2, I_3)", 1e3 * I, "10⁻³ kg m²", "axis 1 along the longest edge", 5);
  result(R"((\dot{\tilde\omega}_1, \dot{\tilde\omega}_2, \dot{\tilde\omega}_3))", omega_rate, "rad/s²",
         "without any torque", 3);
}
//! [euler]

//! [coupled]
TEST_CASE("coupled: On other body axes the three equations are a linear system") {
  const Matrix3d I = tensor_of_four_masses();
  const Vector3d omega(0.3, -0.2, 0.5), torque(0.2, -0.1, 0.3);
  //! [coupled in brief]
  const Vector3d right = euler_equations_general(I, omega, torque);
  const Vector3d right_side = torque - omega.cross(I * omega);
  const Vector3d wrong = right_side.cwiseQuotient(Vector3d(I.diagonal()));
  //! [coupled in brief]

  // Another way: go to the principal axes, use Euler's equations there, and come back.
  const Matrix3d axes = principal_axes(I);
  const Vector3d on_axes = euler_equations(principal_moments(I), axes.transpose() * omega, axes.transpose() * torque);
  CHECK(agrees(right, axes * on_axes, 1e-13));
  CHECK(agrees(right, Vector3d(-0.08670128184, -0.1053740062, 0.01833522635), 1e-9));
  CHECK(agrees(angular_momentum_rate(I, omega, right), torque, 1e-12));
  CHECK((wrong - right).norm() > 0.1 * right.norm());

  result(R"(\dot{\vec\omega})", right, "rad/s²", "the solution of the linear system", 4);
  result(R"(\dot{\vec\omega}_{\mathrm{wrong}})", wrong, "rad/s²", "divided by the diagonal", 4);
}
//! [coupled]

//! [wheel]
TEST_CASE("wheel: A disc that sits askew on its axle shakes the bearings") {
  //! [wheel in brief]
  const double M = 2, R = 0.15, skew = 0.5 * degree;  // kg, m: a grinding disc
  const Matrix3d I = M * R * R * Vector3d(0.25, 0.25, 0.5).asDiagonal();
  const double speed = 1500 * 2 * pi / 60;  // 1500 turns per minute, rad/s
  const Vector3d axle(std::sin(skew), 0, std::cos(skew));
  const Vector3d torque = torque_to_hold_rotation(I, speed * axle);
  const double force = torque.norm() / 0.2;  // on each of two bearings, 0.2 m apart
  //! [wheel in brief]

  CHECK(agrees(torque, Vector3d(0, -speed * speed * M * R * R / 4 * std::sin(skew) * std::cos(skew), 0), 1e-13));
  // Two masses of 0.5 kg at ±0.1 m on a rod at 30° to the axle: each pulls outwards with m ω² a sin 30° on an arm
  // a cos 30° along the axle.
  const double tilt = 30 * degree;
  const Matrix3d dumbbell = inertia_of_points(VectorXd::Constant(2, 0.5), Matrix3Xd{{0, 0}, {0, 0}, {0.1, -0.1}});
  const Vector3d held = torque_to_hold_rotation(dumbbell, speed * Vector3d(std::sin(tilt), 0, std::cos(tilt)));
  const double by_forces = 2 * (0.5 * speed * speed * 0.1 * std::sin(tilt)) * (0.1 * std::cos(tilt));
  // The bearings keep the rod from lying down across the axle, and the disc from standing square to it: opposite
  // senses.
  CHECK(agrees(held, Vector3d(0, by_forces, 0), 1e-13, by_forces));
  CHECK(torque[1] < 0);

  result(R"(\tau)", torque.norm(), "N m", "the torque on the disc", 4);
  result("F", force, "N", "to and fro once per turn", 3);
}
//! [wheel]

TEST_CASE("The torque that holds a rotation is that of the centripetal forces of all points, and does no work") {
  const VectorXd m{{1, 2, 3, 4}};
  const Matrix3Xd r{{1, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 3, 1}};
  const Vector3d omega(0.3, -0.2, 0.5);
  Vector3d by_points = Vector3d::Zero();
  for (int p = 0; p < 4; ++p) {
    const Vector3d r_p = r.col(p);
    by_points += r_p.cross(m[p] * omega.cross(omega.cross(r_p)));
  }
  const Vector3d torque = torque_to_hold_rotation(inertia_of_points(m, r), omega);
  CHECK(agrees(torque, by_points, 1e-14));
  CHECK(agrees(torque, Vector3d(3.58, 3.42, -0.78), 1e-14));
  CHECK(agrees(torque.dot(omega), 0, 1e-15, torque.norm() * omega.norm()));
}

TEST_CASE("Without a torque neither T nor L² changes, while ω does") {
  const Vector3d I(1, 2, 3), omega(0.3, -0.2, 0.5);
  const Vector2d invariants = rotation_invariants(I, omega);
  CHECK(agrees(invariants[0], kinetic_energy(I.asDiagonal(), omega), 1e-15));
  CHECK(agrees(invariants[1], angular_momentum(I.asDiagonal(), omega).squaredNorm(), 1e-15));
  CHECK(agrees(invariants, Vector2d(0.46, 2.5), 1e-15));
  const Vector3d omega_rate = euler_equations(I, omega, Vector3d::Zero());
  CHECK(agrees(omega.dot(I.cwiseProduct(omega_rate)), 0, 1e-15, invariants[0]));
  CHECK(agrees(I.cwiseProduct(omega).dot(I.cwiseProduct(omega_rate)), 0, 1e-15, invariants[1]));
  CHECK(omega_rate.norm() > 0.1);
  // With one T changes at the rate τ·ω.
  const Vector3d torque(0.2, -0.1, 0.3);
  const double h = 1e-4;
  const auto T_after = [&](double t) {
    return rotation_invariants(
        I, integrated(I, {omega}, t, [&](const Motion&) -> const Vector3d& { return torque; }).omega)[0];
  };
  CHECK(agrees((T_after(h) - T_after(-h)) / (2 * h), torque.dot(omega), 1e-8));
}

//! [sign]
TEST_CASE("sign: With the wrong sign of ω × L energy and |L| are still conserved, but L moves in space") {
  const Vector3d I(1, 2, 3);
  //! [sign in brief]
  const Vector3d omega(0.3, -0.2, 0.5);  // rad/s
  const Vector3d L = I.cwiseProduct(omega);
  const Vector3d wrong = omega.cross(L).cwiseQuotient(I);  // should be L × ω
  const double T_rate = omega.dot(I.cwiseProduct(wrong));
  const Vector3d L_rate = angular_momentum_rate(I.asDiagonal(), omega, wrong);
  //! [sign in brief]

  CHECK(agrees(T_rate, 0, 1e-15, 0.46));
  CHECK(agrees(wrong, -euler_equations(I, omega, Vector3d::Zero()), 1e-14));
  CHECK(agrees(L_rate, 2 * torque_to_hold_rotation(I.asDiagonal(), omega), 1e-14));
  CHECK(agrees(angular_momentum_rate(I.asDiagonal(), omega, -wrong), Vector3d::Zero(), 1e-15, 1));

  result(R"(\dot T)", std::abs(T_rate) < 1e-15 ? 0 : T_rate, "W", "the test of energy is passed");
  result(R"(\dot{\vec L})", L_rate, "N m", "in space, where it must be zero");
}
//! [sign]

namespace {

// One step h of three rules for dω/dt = f(ω).
template <class Rate>
Vector3d explicit_euler(const Vector3d& omega, double h, const Rate& f) {
  return omega + h * f(omega);
}

template <class Rate>
Vector3d midpoint(const Vector3d& omega, double h, const Rate& f) {
  return omega + h * f(omega + h / 2 * f(omega));
}

template <class Rate>
Vector3d runge_kutta(const Vector3d& omega, double h, const Rate& f) {
  const Vector3d k1 = f(omega), k2 = f(omega + h / 2 * k1), k3 = f(omega + h / 2 * k2), k4 = f(omega + h * k3);
  return omega + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

template <class Rate, class Rule>
Vector3d after(Vector3d omega, double time, int steps, const Rate& f, const Rule& rule) {
  for (int i = 0; i < steps; ++i) omega = rule(omega, time / steps, f);
  return omega;
}

}  // namespace

//! [steps]
TEST_CASE("steps: What three rules of integration make of 20 s") {
  const Vector3d I = tumbling_body, omega0 = tumbling_start, none = Vector3d::Zero();
  //! [steps in brief]
  const auto f = [&](const Vector3d& w) { return euler_equations(I, w, none); };
  const double h = 0.05;  // s
  Vector3d omega = omega0;
  for (int i = 0; i < 400; ++i) {
    const Vector3d k1 = f(omega), k2 = f(omega + h / 2 * k1);
    const Vector3d k3 = f(omega + h / 2 * k2), k4 = f(omega + h * k3);
    omega += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  //! [steps in brief]

  const Vector3d exact = integrated(I, {omega0}, 20).omega;
  const Vector2d start = rotation_invariants(I, omega0);
  Eigen::MatrixXd table(3, 5);
  const auto examine = [&](int row, int order, const auto& rule) {
    Vector3d coarse = after(omega0, 20, 400, f, rule);
    const Vector3d fine = after(omega0, 20, 800, f, rule);
    const Vector2d drift = (rotation_invariants(I, coarse) - start).cwiseQuotient(start);
    const double factor = (coarse - exact).norm() / (fine - exact).norm();
    table.row(row) << order, (coarse - exact).norm(), drift[0], drift[1], factor;
    CHECK(agrees(factor, std::pow(2, order), 0.3));  // half the step divides the error by 2, 4, 16
    return coarse;
  };
  using Rate = decltype(f);
  examine(0, 1, explicit_euler<Rate>);
  examine(1, 2, midpoint<Rate>);
  CHECK(agrees(examine(2, 4, runge_kutta<Rate>), omega, 1e-15));
  // The explicit Euler rule always gains: each step adds h²/2 Σ I_i (dω_i/dt)² to T, and never takes anything.
  CHECK(table(0, 2) > 0);
  CHECK(table(0, 3) > 0);

  result_table({R"(order \(p\))", R"(error of \(\vec\omega\) / (rad/s))", R"(\(\Delta T/T\))", R"(\(\Delta L^2/L^2\))",
                R"(error divided by, for \(h/2\))"},
               table, 2);
}
//! [steps]

//! [standard]
TEST_CASE("standard: A standard problem for integrators is a free top in disguise") {
  //! [standard in brief]
  const Vector3d I(2, 3, 1);                                              // kg m²
  const Vector3d size(std::sqrt(1.53), std::sqrt(0.51), std::sqrt(3.0));  // rad/s
  const Vector3d omega = free_rotation(I, {0, size[1], size[2]}, VectorXd{{20}});
  const Vector3d y = omega.cwiseQuotient(size);
  double cn = 0, dn = 0;
  const double sn = boost::math::jacobi_elliptic(std::sqrt(0.51), 20.0, &cn, &dn);
  //! [standard in brief]

  CHECK(agrees(y, Vector3d(sn, cn, dn), as_contracted));
  // The rates of y are (y₂y₃, −y₁y₃, −0.51 y₁y₂) at any y.
  const Vector3d any(0.3, -0.7, 0.4);
  CHECK(agrees(euler_equations(I, size.cwiseProduct(any), Vector3d::Zero()).cwiseQuotient(size),
               Vector3d(any[1] * any[2], -any[0] * any[2], -0.51 * any[0] * any[1]), 1e-14));

  result("(y_1, y_2, y_3)", y, "", "by integration", 12);
  result(R"((\mathrm{sn}, \mathrm{cn}, \mathrm{dn}))", Vector3d(sn, cn, dn), "", "by Jacobi's functions", 12);
}
//! [standard]

TEST_CASE("free_rotation reaches the exact solution: motion about axis 3 and about axis 1") {
  // The numbers after 20 s, and the periods after which ω returns to the same body axes, are those of Jacobi's
  // functions.
  const Vector3d I = tumbling_body, omega0 = tumbling_start;
  const Matrix3Xd omega = free_rotation(I, omega0, VectorXd{{20, 22.996262944122, 0}});
  CHECK(agrees(omega.col(0), Vector3d(.6760625658002, .7435989558382, .3987733662439), as_contracted));
  CHECK(agrees(omega.col(1), omega0, as_contracted));
  CHECK(agrees(omega.col(2), omega0, 1e-15));
  const Vector2d before = rotation_invariants(I, omega0);
  CHECK(agrees(rotation_invariants(I, omega.col(0)), before, as_contracted));

  const Matrix3Xd about_1 = free_rotation(I, {1, 0.5, 0.25}, VectorXd{{20, 10.809345300803}});
  CHECK(agrees(about_1.col(0), Vector3d(1.1135114730861, -.1004599388101, .3774510125806), as_contracted));
  CHECK(agrees(about_1.col(1), Vector3d(1, 0.5, 0.25), as_contracted));
}

//! [attitude]
TEST_CASE("attitude: Where the body is after 20 s") {
  const Vector3d I = tumbling_body;
  //! [attitude in brief]
  const double h = 0.001;  // s
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Vector3d omega = tumbling_start;
  for (int i = 0; i < 20000; ++i) {  // by the midpoint rule
    const Vector3d halfway = omega + h / 2 * euler_equations(I, omega, Vector3d::Zero());
    q = q * Eigen::AngleAxisd(h * halfway.norm(), halfway.normalized());
    omega += h * euler_equations(I, halfway, Vector3d::Zero());
  }
  const Vector3d L = q * I.cwiseProduct(omega);
  //! [attitude in brief]

  const Vector3d L0 = I.cwiseProduct(tumbling_start);
  CHECK(agrees(L, L0, 1e-5));
  // The exact attitude, as quaternion w, x, y, z.
  const Eigen::Quaterniond exact(.8943134452209, -.3031012358653, -.3290751190338, .0065321165755);
  const Motion end = integrated(I, {tumbling_start}, 20);
  CHECK(agrees(end.A, exact.toRotationMatrix(), 1e-10));
  CHECK(agrees(end.A * I.cwiseProduct(end.omega), L0, 1e-11));
  CHECK(agrees(q.toRotationMatrix(), end.A, 1e-5));
  CHECK(agrees(free_rotation(I, tumbling_start, VectorXd{{20}}), end.omega, as_contracted));

  result(R"(\vec L_\bodyframe)", I.cwiseProduct(omega), "kg m²/s", "after 20 s; it began as (0.1, 2, 0.3) kg m²/s", 4);
  result(R"(\vec L_\inertialframe)", L, "kg m²/s", "where it was at the start", 4);
}
//! [attitude]

//! [tilde]
TEST_CASE("tilde: Inertial components in Euler's equations give a meaningless result") {
  const Vector3d I = tumbling_body, none = Vector3d::Zero();
  //! [tilde in brief]
  const Motion now = integrated(I, {tumbling_start}, 5);  // ω_body and A after 5 s
  const Vector3d omega_inertial = now.A * now.omega;
  const Vector3d right = now.A * euler_equations(I, now.omega, none);
  const Vector3d wrong = euler_equations(I, omega_inertial, none);
  //! [tilde in brief]

  // The rate of ω seen from the inertial frame is the same vector: the frames differ by ω × ω, which is zero.
  const Motion later = integrated(I, now, 1e-3), earlier = integrated(I, now, -1e-3);
  CHECK(agrees((later.A * later.omega - earlier.A * earlier.omega) / 2e-3, right, 1e-5));
  CHECK((wrong - right).norm() > 0.1 * right.norm());
  CHECK((wrong - euler_equations(I, now.omega, none)).norm() > 0.1 * right.norm());

  result(R"(\vec\omega_\bodyframe)", now.omega, "rad/s", "on the axes of the body", 4);
  result(R"(\vec\omega_\inertialframe)", omega_inertial, "rad/s", "the same vector on axes at rest", 4);
  result(R"(\dot{\vec\omega}_\inertialframe)", right, "rad/s²", "Euler's equations in the body, then the components",
         3);
  result(R"(\dot{\vec\omega}_{\mathrm{wrong}})", wrong, "rad/s²", "Euler's equations with inertial components", 3);
}
//! [tilde]

//! [thruster]
TEST_CASE("thruster: A torque fixed in the body leaves Euler's equations closed") {
  //! [thruster in brief]
  const double I1 = 1, I3 = 1.8, torque = 0.9;  // kg m², N m: a small satellite
  const double t = 8;                           // s
  const double omega3 = 2 + torque / I3 * t;
  const double angle = (I3 - I1) / I1 * (2 * t + torque / I3 * t * t / 2);
  const Vector3d omega(0.4 * std::cos(angle), 0.4 * std::sin(angle), omega3);
  //! [thruster in brief]

  const auto f = [&](const Vector3d& w) { return euler_equations({I1, I1, I3}, w, {0, 0, torque}); };
  CHECK(agrees(after(Vector3d(0.4, 0, 2), t, 8000, f, runge_kutta<decltype(f)>), omega, 1e-8));

  result(R"(\vec\omega)", omega, "rad/s", R"(after 8 s from \((0.4, 0, 2)\) rad/s, as integration confirms)");
}
//! [thruster]

TEST_CASE(
    "A torque fixed in space needs the attitude: in space L grows by τ t, and no torque on body axes does the same") {
  const Vector3d I = tumbling_body, torque_inertial(0.2, -0.1, 0.3);
  const auto fixed_in_space = [&](const Motion& now) -> Vector3d { return now.A.transpose() * torque_inertial; };
  const Motion end = integrated(I, {tumbling_start}, 10, fixed_in_space);
  CHECK(agrees(end.A * I.cwiseProduct(end.omega), I.cwiseProduct(tumbling_start) + 10 * torque_inertial, 1e-11));
  CHECK(agrees(euler_equations(I, end.omega, fixed_in_space(end)), rate_by_waiting(I, end, fixed_in_space), 1e-6));
  const Motion other =
      integrated(I, {tumbling_start}, 10, [&](const Motion&) -> const Vector3d& { return torque_inertial; });
  CHECK((other.omega - end.omega).norm() > 0.1);
}

TEST_CASE("Hard arguments: a sphere, a principal axis and a body at rest stay as they are") {
  const VectorXd times{{-7, 0, 1e-8, 3, 20}};
  for (const auto& [I, omega0] :
       {std::pair{Vector3d(2, 2, 2), Vector3d(0.3, -0.2, 0.5)}, std::pair{Vector3d(1, 2, 3), Vector3d(0, 1, 0)},
        std::pair{Vector3d(1, 2, 3), Vector3d(0, 0, -2)}, std::pair{Vector3d(1, 2, 3), Vector3d(0, 0, 0)}}) {
    CHECK(agrees(free_rotation(I, omega0, times), omega0.replicate(1, times.size()), 1e-13, 1));
    CHECK(agrees(torque_to_hold_rotation(I.asDiagonal(), omega0), Vector3d::Zero(), 1e-15, 1));
    CHECK(agrees(euler_equations(I, omega0, Vector3d::Zero()), Vector3d::Zero(), 1e-15, 1));
  }
}

TEST_CASE("Hard arguments: no times, repeated times, times before zero and in no order") {
  const Vector3d I = tumbling_body, omega0 = tumbling_start;
  CHECK(free_rotation(I, omega0, VectorXd(0)).cols() == 0);

  const VectorXd times{{4, -2.5, 4, 0, -11}};
  const Matrix3Xd omega = free_rotation(I, omega0, times);
  REQUIRE(omega.cols() == times.size());
  for (int k = 0; k < times.size(); ++k)
    CHECK(agrees(omega.col(k), integrated(I, {omega0}, times[k]).omega, as_contracted));

  // What was forwards is undone backwards.
  const Vector3d there = free_rotation(I, omega0, VectorXd{{20}});
  CHECK(agrees(free_rotation(I, there, VectorXd{{-20}}), omega0, 10 * as_contracted));
}

TEST_CASE("Hard arguments: close to a principal axis, ω moves as the linearized equations say") {
  // Rotation about axis 3 with a disturbance ε along axis 1: ω₁ = ε cos t and ω₂ = ε sin t up to terms in ε³.
  const Vector3d I(1, 2, 3);
  for (const double disturbance : {1e-8, 1e-3}) {
    const Vector3d rate = euler_equations(I, Vector3d(disturbance, 0, 1), Vector3d::Zero());
    CHECK(agrees(rate, Vector3d(0, disturbance, 0), 1e-15, disturbance));
    const Vector3d omega = free_rotation(I, Vector3d(disturbance, 0, 1), VectorXd{{2}});
    CHECK(agrees(omega, Vector3d(disturbance * std::cos(2), disturbance * std::sin(2), 1), as_contracted));
  }
}

TEST_CASE("Hard arguments: two nearly equal moments behave like two equal ones") {
  const Vector3d omega0(0.3, 0.5, 0.8);
  const VectorXd times{{-3, 12}};
  const Matrix3Xd equal = free_rotation(Vector3d(1, 1, 1.5), omega0, times);
  CHECK(agrees(free_rotation(Vector3d(1, 1 + 1e-9, 1.5), omega0, times), equal, as_contracted));
  for (int k = 0; k < 2; ++k) {  // the symmetric top of lecture 06: ω₁, ω₂ go round steadily
    const Vector2d rotated = Eigen::Rotation2Dd(0.5 * omega0[2] * times[k]) * Vector2d(omega0.head<2>());
    CHECK(agrees(equal.col(k).head<2>(), rotated, as_contracted));
  }
}
