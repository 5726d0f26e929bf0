// Worked examples of lecture 05. Each case is a paragraph of the notes that computes its own numbers.
#include "lectures/support/agrees.hpp"
#include "lectures/support/printed.hpp"

#include <rigid/euler_equations.hpp>
#include <rigid/inertia_tensor.hpp>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <cmath>
#include <numbers>
#include <utility>

using namespace rigid;
using workbook::agrees;
using workbook::Printed;
using workbook::row;

namespace {

/// What the contract asks of an integration, and so all that an example may ask of free_rotation().
constexpr double integrated = 1e-6;

/// The tensor of lecture 03's body: four masses, one on each axis and one off all of them.
Matrix3d tensor_of_four_masses() {
  return inertia_of_points(VectorXd{{1, 2, 3, 4}}, Matrix3Xd{{1, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 3, 1}});
}

/// The attitude after a turn by a constant rotation vector (axis times angle).
Matrix3d turned_by(const Vector3d& rotation_vector) {
  return Eigen::AngleAxisd(rotation_vector.norm(), rotation_vector.normalized()).toRotationMatrix();
}

}  // namespace

//! [rate of momentum]
TEST_CASE("The rate of L in the inertial frame is what the body sees, plus ω × L") {
  const Matrix3d I = tensor_of_four_masses();
  const Vector3d omega(0.3, -0.2, 0.5), omega_rate(0.1, 0.2, -0.3);

  // The long way: let the body turn for a short time h either way, and look at L from the inertial frame.
  const auto L_inertial = [&](double h) -> Vector3d {
    const Matrix3d A = turned_by(h * omega + h * h / 2 * omega_rate);  // attitude, right to second order in h
    return A * (I * (omega + h * omega_rate));
  };
  const double h = 1e-4;
  const Vector3d by_waiting = (L_inertial(h) - L_inertial(-h)) / (2 * h);

  const Vector3d rate = angular_momentum_rate(I, omega, omega_rate);

  CHECK(agrees(rate, by_waiting, 1e-7));
  CHECK(agrees(rate, Vector3d(8.28, 11.42, -7.08), 1e-14));

  Printed page("rate of momentum");
  page.line("seen from the body,  I dω/dt     = {} N m", row(I * omega_rate));
  page.line("of the turning axes, ω × (I ω)   = {} N m", row(rate - I * omega_rate));
  page.line("inertial frame,      sum of both = {} N m", row(rate));
}
//! [rate of momentum]

//! [on principal axes]
TEST_CASE("On principal axes the turning of the axes makes the slides' three differences of moments") {
  const Vector3d I(1, 2, 3), omega(0.3, -0.2, 0.5), omega_rate(0.1, 0.2, -0.3);

  // S0 s18: along each axis I_i dω_i/dt, and the product of the two other components of ω.
  const Vector3d slides(I[0] * omega_rate[0] + omega[1] * omega[2] * (I[2] - I[1]),
                        I[1] * omega_rate[1] + omega[2] * omega[0] * (I[0] - I[2]),
                        I[2] * omega_rate[2] + omega[0] * omega[1] * (I[1] - I[0]));

  CHECK(agrees(angular_momentum_rate(I.asDiagonal(), omega, omega_rate), slides, 1e-14));

  Printed page("on principal axes");
  page.line("dL/dt on the principal axes = {} N m", row(slides));
}
//! [on principal axes]

//! [euler]
TEST_CASE("Euler's equations give the dω/dt whose torque is the given one") {
  const Vector3d I(1, 2, 3), omega(0.3, -0.2, 0.5), torque(0.2, -0.1, 0.3);

  const Vector3d omega_rate = euler_equations(I, omega, torque);

  // By hand, line by line: I₁ dω₁/dt = τ₁ − ω₂ω₃(I₃ − I₂) = 0.2 + 0.1, and so on.
  CHECK(agrees(omega_rate, Vector3d(0.3, 0.1, 0.12), 1e-14));
  // Put back into the rate of L, it returns the torque.
  CHECK(agrees(angular_momentum_rate(I.asDiagonal(), omega, omega_rate), torque, 1e-14));

  Printed page("euler");
  page.line("dω/dt = {} rad/s²", row(omega_rate));
  page.line("I dω/dt alone would be {} N m, the torque is {} N m", row(I.cwiseProduct(omega_rate)), row(torque));
}
//! [euler]

//! [any axes]
TEST_CASE("On other body axes the three equations are coupled, and a linear system takes their place") {
  const Matrix3d I = tensor_of_four_masses();
  const Vector3d omega(0.3, -0.2, 0.5), torque(0.2, -0.1, 0.3);

  const Vector3d omega_rate = euler_equations_general(I, omega, torque);

  // Another way: go to the principal axes, use Euler's equations there, and come back.
  const Matrix3d axes = principal_axes(I);
  const Vector3d on_axes = euler_equations(principal_moments(I), axes.transpose() * omega, axes.transpose() * torque);
  CHECK(agrees(omega_rate, axes * on_axes, 1e-13));
  CHECK(agrees(omega_rate, Vector3d(-0.08670128184, -0.1053740062, 0.01833522635), 1e-9));
  CHECK(agrees(angular_momentum_rate(I, omega, omega_rate), torque, 1e-12));

  Printed page("any axes");
  page.line("dω/dt = {} rad/s²", row(omega_rate));
}
//! [any axes]

//! [hold]
TEST_CASE("To hold a rotation takes a torque, and adding up the points of the body gives the same one") {
  const VectorXd m{{1, 2, 3, 4}};
  const Matrix3Xd r{{1, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 3, 1}};
  const Vector3d omega(0.3, -0.2, 0.5);

  // Every point is pulled round its circle with the acceleration ω × (ω × r): Newton's law, times r.
  Vector3d by_points = Vector3d::Zero();
  for (int p = 0; p < 4; ++p) {
    const Vector3d r_p = r.col(p);
    by_points += r_p.cross(m[p] * omega.cross(omega.cross(r_p)));
  }

  const Vector3d torque = torque_to_hold_rotation(inertia_of_points(m, r), omega);

  CHECK(agrees(torque, by_points, 1e-14));
  CHECK(agrees(torque, Vector3d(3.58, 3.42, -0.78), 1e-14));
  CHECK(agrees(torque.dot(omega), 0, 1e-15, torque.norm() * omega.norm()));  // it does no work

  Printed page("hold");
  page.line("torque = {} N m", row(torque));
}
//! [hold]

//! [skewed wheel]
TEST_CASE("A wheel skewed on its axle shakes its bearings, and so does a tilted dumbbell") {
  const double degree = std::numbers::pi / 180;
  const double speed = 1500 * 2 * std::numbers::pi / 60;  // 1500 turns per minute
  const double bearings = 0.2;                            // their distance, m

  // A thin wheel of 2 kg and radius 0.15 m: moment MR²/2 about its own axis, half of that about a diameter. The body
  // axes are its own, the third one across the wheel; the axle, along ω, makes a small angle with it.
  const double M = 2, R = 0.15, skew = 0.5 * degree;
  const Matrix3d wheel = M * R * R * Vector3d(0.25, 0.25, 0.5).asDiagonal();
  const Vector3d axle(std::sin(skew), 0, std::cos(skew));
  const Vector3d torque = torque_to_hold_rotation(wheel, speed * axle);
  CHECK(agrees(torque, Vector3d(0, -speed * speed * M * R * R / 4 * std::sin(skew) * std::cos(skew), 0), 1e-13));

  // A dumbbell of two masses m at ±a along the body's third axis, held at 30° to the axle through its middle. Each
  // mass pulls outwards with the centrifugal force m ω² a sin 30° on an arm a cos 30° along the axle.
  const double m = 0.5, a = 0.1, tilt = 30 * degree;
  const Matrix3d dumbbell = inertia_of_points(VectorXd{{m, m}}, Matrix3Xd{{0, 0}, {0, 0}, {a, -a}});
  const Vector3d tilted_axle(std::sin(tilt), 0, std::cos(tilt));
  const double by_forces = 2 * (m * speed * speed * a * std::sin(tilt)) * (a * std::cos(tilt));
  const Vector3d held = torque_to_hold_rotation(dumbbell, speed * tilted_axle);
  CHECK(agrees(held.norm(), by_forces, 1e-13));
  CHECK(held[1] > 0);    // the bearings keep the rod from lying down across the axle ...
  CHECK(torque[1] < 0);  // ... and the wheel from standing square to it: the opposite sense

  Printed page("skewed wheel");
  page.line("wheel, skewed by 0.5°:  torque {:.3f} N m, {:.1f} N on each of two bearings {} m apart", torque.norm(),
            torque.norm() / bearings, bearings);
  page.line("dumbbell, tilted by 30°: torque {:.2f} N m, {:.0f} N on each bearing", held.norm(),
            held.norm() / bearings);
}
//! [skewed wheel]

//! [invariants]
TEST_CASE("Without a torque neither T nor L² changes, because dω/dt is at right angles to both gradients") {
  const Vector3d I(1, 2, 3), omega(0.3, -0.2, 0.5);
  const Vector3d L = I.cwiseProduct(omega);

  const Vector2d invariants = rotation_invariants(I, omega);
  CHECK(agrees(invariants[0], kinetic_energy(I.asDiagonal(), omega), 1e-15));
  CHECK(agrees(invariants[1], angular_momentum(I.asDiagonal(), omega).squaredNorm(), 1e-15));
  CHECK(agrees(invariants, Vector2d(0.46, 2.5), 1e-15));

  // dT/dt = Σ I_i ω_i dω_i/dt = ω·(I dω/dt) and d(L²)/dt = 2 L·(I dω/dt), where I dω/dt = −ω × L: both triple products
  // vanish.
  const Vector3d omega_rate = euler_equations(I, omega, Vector3d::Zero());
  const double T_rate = omega.dot(I.cwiseProduct(omega_rate));
  const double L_squared_rate = 2 * L.dot(I.cwiseProduct(omega_rate));
  CHECK(agrees(T_rate, 0, 1e-15, invariants[0]));
  CHECK(agrees(L_squared_rate, 0, 1e-15, invariants[1]));
  CHECK(omega_rate.norm() > 0.1);  // and all the while ω does change

  Printed page("invariants");
  page.line("T = {:.10g} J, L² = {:.10g} kg² m⁴/s²", invariants[0], invariants[1]);
  page.line("dω/dt = {} rad/s²", row(omega_rate));
}
//! [invariants]

//! [wrong sign]
TEST_CASE("One wrong turn: the wrong sign of ω × L passes both conservation laws") {
  const Vector3d I(1, 2, 3), omega(0.3, -0.2, 0.5);
  const Vector3d right = euler_equations(I, omega, Vector3d::Zero());
  const Vector3d wrong = -right;

  // T and L² stay for both: the wrong sign only runs the film backwards.
  CHECK(agrees(omega.dot(I.cwiseProduct(wrong)), 0, 1e-15, 0.46));
  // What tells them apart is L in space, which must stand still.
  const Vector3d L_rate_right = angular_momentum_rate(I.asDiagonal(), omega, right);
  const Vector3d L_rate_wrong = angular_momentum_rate(I.asDiagonal(), omega, wrong);
  CHECK(agrees(L_rate_right, Vector3d::Zero(), 1e-15, 1));
  CHECK(agrees(L_rate_wrong, 2 * torque_to_hold_rotation(I.asDiagonal(), omega), 1e-14));

  Printed page("wrong sign");
  page.line("dL/dt in space, right sign: {} N m", row(L_rate_right));
  page.line("dL/dt in space, wrong sign: {} N m", row(L_rate_wrong));
}
//! [wrong sign]

namespace {

//! [exact solution]
// The exact free rotation of a body with moments in ascending order, off the separatrix, by Jacobi's functions.
class ExactRotation {
 public:
  ExactRotation(Vector3d I, Vector3d omega) {
    // With L² > 2T I₂ the vector L circles axis 3; otherwise it circles axis 1, and the two exchange their labels.
    const Vector2d invariants = rotation_invariants(I, omega);
    relabelled_ = invariants[1] < 2 * invariants[0] * I[1];
    if (relabelled_) {
      std::swap(I[0], I[2]);
      std::swap(omega[0], omega[2]);
    }
    const double twice_T = 2 * invariants[0], L_squared = invariants[1];
    const double below = L_squared - twice_T * I[0], above = twice_T * I[2] - L_squared;
    sense_ = omega[2] < 0 ? -1 : 1;
    amplitudes_ =
        Vector3d(above / (I[0] * (I[2] - I[0])), above / (I[1] * (I[2] - I[1])), below / (I[2] * (I[2] - I[0])))
            .cwiseSqrt();
    rate = std::sqrt(below * (I[2] - I[1]) / I.prod());
    parameter = above * (I[1] - I[0]) / (below * (I[2] - I[1]));
    modulus_ = std::sqrt(parameter);  // Boost takes the modulus k, and takes it first; m = k²
    start_ = boost::math::ellint_1(modulus_, std::atan2(sense_ * omega[1] / amplitudes_[1], omega[0] / amplitudes_[0]));
    period = 4 * boost::math::ellint_1(modulus_) / rate;
  }

  Vector3d at(double t) const {
    double cn = 0, dn = 0;
    const double sn = boost::math::jacobi_elliptic(modulus_, rate * t + start_, &cn, &dn);
    Vector3d omega = amplitudes_.cwiseProduct(Vector3d(cn, sense_ * sn, sense_ * dn));
    if (relabelled_) std::swap(omega[0], omega[2]);
    return omega;
  }

  double rate;       // λ, 1/s
  double parameter;  // m
  double period;     // of ω in the body, s

 private:
  bool relabelled_;
  double sense_, modulus_, start_;
  Vector3d amplitudes_;
};
//! [exact solution]

}  // namespace

//! [free top]
TEST_CASE("A free asymmetric top: the integration reaches the exact solution") {
  const Vector3d I(1, 2, 3), omega0(0.1, 1, 0.1);
  const ExactRotation exact(I, omega0);
  CHECK(agrees(exact.parameter, 0.980582524272, 1e-11));
  CHECK(agrees(exact.rate, 0.585946527708, 1e-11));
  CHECK(agrees(exact.period, 22.996262944122, 1e-11));
  CHECK(agrees(exact.at(20), Vector3d(.6760625658002, .7435989558382, .3987733662439), 1e-11));

  const Matrix3Xd omega = free_rotation(I, omega0, VectorXd{{20, exact.period, 0}});

  CHECK(agrees(omega.col(0), exact.at(20), integrated));
  CHECK(agrees(omega.col(0), Vector3d(.6760625658, .7435989558, .3987733662), integrated));
  CHECK(agrees(omega.col(1), omega0, integrated));  // after a period ω is back on the same body axes
  CHECK(agrees(omega.col(2), omega0, 1e-15));       // and at t = 0 nothing has happened yet
  const Vector2d before = rotation_invariants(I, omega0), after = rotation_invariants(I, omega.col(0));
  CHECK(agrees(after[0], before[0], integrated));
  CHECK(agrees(after[1], before[1], integrated));

  Printed page("free top");
  page.line("m = {:.12f}, λ = {:.12f} 1/s, period = {:.9f} s", exact.parameter, exact.rate, exact.period);
  page.line("ω(20 s) = {} rad/s, exact", row(exact.at(20)));
  page.line("ω(20 s) = {} rad/s, integrated", row(omega.col(0)));
}
//! [free top]

//! [about the smallest moment]
TEST_CASE("A faster start about the axis of the smallest moment: the same formula with labels 1 and 3 exchanged") {
  const Vector3d I(1, 2, 3), omega0(1, 0.5, 0.25);
  const ExactRotation exact(I, omega0);
  CHECK(agrees(exact.parameter, 0.35, 1e-13));
  CHECK(agrees(exact.period, 10.809345300803, 1e-12));
  CHECK(agrees(exact.at(20), Vector3d(1.1135114730861, -.1004599388101, .3774510125806), 1e-11));
  CHECK(agrees(free_rotation(I, omega0, VectorXd{{20}}), exact.at(20), integrated));

  Printed page("about the smallest moment");
  page.line("m = {:.10g}, period = {:.9f} s, ω(20 s) = {} rad/s", exact.parameter, exact.period, row(exact.at(20)));
}
//! [about the smallest moment]

//! [three functions]
TEST_CASE("V20 DETEST B5: every free top is sn, cn and dn, up to the lengths of its axes") {
  // A standard problem for integrators: y₁' = y₂y₃, y₂' = −y₁y₃, y₃' = −0.51 y₁y₂ from (0, 1, 1). Its solution is
  // (sn t, cn t, dn t) with m = 0.51. The moments (2, 3, 1) have the right signs; ω_i = c_i y_i sets the sizes.
  const Vector3d I(2, 3, 1);
  const Vector3d c(std::sqrt(1.53), std::sqrt(0.51), std::sqrt(3.0));
  const Vector3d y0(0, 1, 1);
  const Vector3d omega = free_rotation(I, c.cwiseProduct(y0), VectorXd{{20}});
  const Vector3d y = omega.cwiseQuotient(c);

  // W. H. Enright and J. D. Pryce, test set for initial value problems, problem B5; MATLAB's example rigidode.
  const Vector3d published(-0.9396570798729192, -0.3421177754000779, 0.7414126596199957);
  double cn = 0, dn = 0;
  const double sn = boost::math::jacobi_elliptic(std::sqrt(0.51), 20.0, &cn, &dn);
  CHECK(agrees(Vector3d(sn, cn, dn), published, 1e-12));
  CHECK(agrees(y, published, integrated));

  Printed page("V20");
  page.line("V20 | {} | {} | 1e-12", row(published, "{:.12f}"), row(y, "{:.12f}"));
}
//! [three functions]

namespace {

//! [steppers]
// One step h of three rules for dy/dt = f(y).
template <class State, class Rate>
State explicit_euler(const State& y, double h, const Rate& f) {
  return y + h * f(y);
}

template <class State, class Rate>
State midpoint(const State& y, double h, const Rate& f) {
  const State halfway = y + h / 2 * f(y);
  return y + h * f(halfway);
}

template <class State, class Rate>
State runge_kutta(const State& y, double h, const Rate& f) {
  const State k1 = f(y);
  const State k2 = f(State(y + h / 2 * k1));
  const State k3 = f(State(y + h / 2 * k2));
  const State k4 = f(State(y + h * k3));
  return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}
//! [steppers]

template <class State, class Rate, class Stepper>
State after(State y, double time, int steps, const Rate& f, const Stepper& step) {
  for (int i = 0; i < steps; ++i) y = step(y, time / steps, f);
  return y;
}

/// Attitude and ω together: the attitude is a quaternion, kept with ω in one list (x, y, z, w, ω₁, ω₂, ω₃).
using Motion = Eigen::Matrix<double, 7, 1>;

Motion from_rest_attitude(const Vector3d& omega) { return (Motion() << 0, 0, 0, 1, omega).finished(); }
Vector3d omega_of(const Motion& motion) { return motion.tail<3>(); }
Matrix3d attitude_of(const Motion& motion) {
  return Eigen::Quaterniond(motion.head<4>()).normalized().toRotationMatrix();
}

/// Its rate under a torque on the body axes: q̇ = ½ q ω, and Euler's equations.
Motion motion_rate(const Vector3d& I, const Motion& motion, const Vector3d& torque_body) {
  const Vector3d omega = omega_of(motion);
  const Eigen::Quaterniond half(0, omega.x() / 2, omega.y() / 2, omega.z() / 2);
  const Eigen::Quaterniond q_rate = Eigen::Quaterniond(motion.head<4>()) * half;
  return (Motion() << q_rate.coeffs(), euler_equations(I, omega, torque_body)).finished();
}

}  // namespace

//! [drift]
TEST_CASE("What a rule of integration makes of T and L²") {
  const Vector3d I(1, 2, 3), omega0(0.1, 1, 0.1);
  const auto rate = [&](const Vector3d& omega) -> Vector3d { return euler_equations(I, omega, Vector3d::Zero()); };
  const Vector3d exact = ExactRotation(I, omega0).at(20);
  const Vector2d start = rotation_invariants(I, omega0);
  Printed page("drift");
  page.line("20 s in 400 steps   error of ω    drift of T    drift of L²   error falls by");

  const auto examine = [&](const char* name, const auto& step, double expected_factor) {
    const Vector3d coarse = after(omega0, 20, 400, rate, step);
    const Vector3d fine = after(omega0, 20, 800, rate, step);
    const Vector2d drift = (rotation_invariants(I, coarse) - start).cwiseQuotient(start);
    // Half the step divides the error by 2, 4, 16 for rules of order 1, 2, 4.
    const double factor = (coarse - exact).norm() / (fine - exact).norm();
    CHECK(agrees(factor, expected_factor, 0.3));
    page.line("{:<18}  {:9.1e}     {:+9.1e}     {:+9.1e}     {:5.1f}", name, (coarse - exact).norm(), drift[0],
              drift[1], factor);
    return drift;
  };
  using Rate = decltype(rate);
  const Vector2d euler = examine("explicit Euler", explicit_euler<Vector3d, Rate>, 2);
  examine("midpoint", midpoint<Vector3d, Rate>, 4);
  examine("Runge-Kutta", runge_kutta<Vector3d, Rate>, 16);
  CHECK(euler[0] > 0);  // it always gains: each step adds h²/2 Σ I_i (dω_i/dt)² to T, and never takes anything
  CHECK(euler[1] > 0);
}
//! [drift]

//! [attitude]
TEST_CASE("Where the body is after 20 s: ω in the body says, with L at rest in space as the witness") {
  const Vector3d I(1, 2, 3), omega0(0.1, 1, 0.1);
  const auto rate = [&](const Motion& motion) { return motion_rate(I, motion, Vector3d::Zero()); };

  const Motion end = after(from_rest_attitude(omega0), 20, 4000, rate, runge_kutta<Motion, decltype(rate)>);

  const Matrix3d A = attitude_of(end);
  const Eigen::Vector4d exact(.8943134452209, -.3031012358653, -.3290751190338, .0065321165755);  // w, x, y, z
  const Eigen::Quaterniond q(exact[0], exact[1], exact[2], exact[3]);
  CHECK(agrees(A, q.toRotationMatrix(), 1e-9));
  CHECK(agrees(A * I.cwiseProduct(omega_of(end)), I.cwiseProduct(omega0), 1e-9));
  CHECK(agrees(omega_of(end), free_rotation(I, omega0, VectorXd{{20}}), integrated));

  Printed page("attitude");
  page.line("L at rest: {} at 0 s, {} at 20 s (inertial, kg m²/s)", row(I.cwiseProduct(omega0), "{:.6f}"),
            row(A * I.cwiseProduct(omega_of(end)), "{:.6f}"));
  page.line("L in the body: {} at 20 s", row(I.cwiseProduct(omega_of(end)), "{:.6f}"));
  page.line("A(20 s) =");
  page.matrix(A, "{:12.8f}");
}
//! [attitude]

//! [tilde]
TEST_CASE("The tilde matters: ω has other components in space, but dω/dt is one vector for both frames") {
  const Vector3d I(1, 2, 3), omega0(0.1, 1, 0.1);
  const auto rate = [&](const Motion& motion) { return motion_rate(I, motion, Vector3d::Zero()); };
  const auto motion_at = [&](double t) {
    return after(from_rest_attitude(omega0), t, 1000, rate, runge_kutta<Motion, decltype(rate)>);
  };
  const auto omega_inertial = [&](double t) -> Vector3d { return attitude_of(motion_at(t)) * omega_of(motion_at(t)); };

  const Motion then = motion_at(5);
  const Vector3d omega_body = omega_of(then);
  const Vector3d by_waiting = (omega_inertial(5.001) - omega_inertial(4.999)) / 0.002;
  const Vector3d turned = attitude_of(then) * euler_equations(I, omega_body, Vector3d::Zero());
  CHECK(agrees(by_waiting, turned, 1e-5));  // dω/dt differs between the frames by ω × ω, which is zero

  // Put inertial components into Euler's equations, and the answer is another one.
  const Vector3d mistaken = euler_equations(I, omega_inertial(5), Vector3d::Zero());
  CHECK((mistaken - turned).norm() > 0.1 * turned.norm());
  CHECK((mistaken - euler_equations(I, omega_body, Vector3d::Zero())).norm() > 0.1 * turned.norm());

  Printed page("tilde");
  page.line("ω at 5 s on body axes:      {} rad/s", row(omega_body, "{:.6f}"));
  page.line("ω at 5 s on inertial axes:  {} rad/s", row(omega_inertial(5), "{:.6f}"));
  page.line("dω/dt from the first:       {} rad/s² on body axes",
            row(euler_equations(I, omega_body, Vector3d::Zero()), "{:.6f}"));
  page.line("Euler's rule on the second: {} rad/s², meaningless", row(mistaken, "{:.6f}"));
}
//! [tilde]

//! [body torque]
TEST_CASE("A torque fixed in the body leaves Euler's equations closed: a thruster spins up a symmetric satellite") {
  const Vector3d I(1, 1, 1.8), omega0(0.4, 0, 2), torque(0, 0, 0.9);
  const auto rate = [&](const Vector3d& omega) { return euler_equations(I, omega, torque); };
  const double t = 8;

  const Vector3d omega = after(omega0, t, 8000, rate, runge_kutta<Vector3d, decltype(rate)>);

  // By hand: ω₃ grows evenly, and ω₁ + iω₂ turns through the integral of (I₃ − I₁)/I₁ ω₃.
  const double omega3 = omega0[2] + torque[2] / I[2] * t;
  const double phase = (I[2] - I[0]) / I[0] * (omega0[2] * t + torque[2] / I[2] * t * t / 2);
  CHECK(agrees(omega, Vector3d(0.4 * std::cos(phase), 0.4 * std::sin(phase), omega3), 1e-8));

  Printed page("body torque");
  page.line("ω({} s) = {} rad/s integrated", t, row(omega, "{:.8f}"));
  page.line("        = {} rad/s by hand",
            row(Vector3d(0.4 * std::cos(phase), 0.4 * std::sin(phase), omega3), "{:.8f}"));
}
//! [body torque]

//! [space torque]
TEST_CASE("A torque fixed in space needs the attitude as well: six equations instead of three") {
  const Vector3d I(1, 2, 3), omega0(0.1, 1, 0.1), torque_inertial(0.2, -0.1, 0.3);
  const double t = 10;
  // Its components on the body axes depend on the attitude, so dω/dt cannot be had from ω alone.
  const auto rate = [&](const Motion& motion) {
    return motion_rate(I, motion, attitude_of(motion).transpose() * torque_inertial);
  };

  const Motion end = after(from_rest_attitude(omega0), t, 10000, rate, runge_kutta<Motion, decltype(rate)>);

  // In space the law is the simplest there is, dL/dt = τ.
  const Vector3d L_end = attitude_of(end) * I.cwiseProduct(omega_of(end));
  CHECK(agrees(L_end, I.cwiseProduct(omega0) + t * torque_inertial, 1e-9));
  // The same three numbers held on the body axes make another motion.
  const auto body_fixed = [&](const Motion& motion) { return motion_rate(I, motion, torque_inertial); };
  const Motion other =
      after(from_rest_attitude(omega0), t, 10000, body_fixed, runge_kutta<Motion, decltype(body_fixed)>);
  CHECK((omega_of(other) - omega_of(end)).norm() > 0.1);

  Printed page("space torque");
  page.line("L(0) + τ t   = {} kg m²/s", row(I.cwiseProduct(omega0) + t * torque_inertial, "{:.6f}"));
  page.line("A(t) I ω(t)  = {} kg m²/s", row(L_end, "{:.6f}"));
  page.line("ω({} s), torque fixed in space:    {} rad/s", t, row(omega_of(end), "{:.6f}"));
  page.line("ω({} s), torque fixed in the body: {} rad/s", t, row(omega_of(other), "{:.6f}"));
}
//! [space torque]

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
  const Vector3d I(1, 2, 3), omega0(0.1, 1, 0.1);
  CHECK(free_rotation(I, omega0, VectorXd(0)).cols() == 0);

  const VectorXd times{{4, -2.5, 4, 0, -11}};
  const Matrix3Xd omega = free_rotation(I, omega0, times);
  REQUIRE(omega.cols() == times.size());
  const ExactRotation exact(I, omega0);
  for (int k = 0; k < times.size(); ++k) CHECK(agrees(omega.col(k), exact.at(times[k]), integrated));

  // What was forwards is undone backwards.
  const Vector3d there = free_rotation(I, omega0, VectorXd{{20}});
  CHECK(agrees(free_rotation(I, there, VectorXd{{-20}}), omega0, 10 * integrated));
}

TEST_CASE("Hard arguments: close to a principal axis, ω wobbles at the rate of the linearised equations") {
  // Spin about axis 3 with a disturbance ε along axis 1: ω₁ swings as ε cos(√(Ω₁Ω₂) t) up to terms in ε³, and
  // ω₂ as ε √(Ω₂/Ω₁) sin. Here Ω₁ = 1 and Ω₂ = 1 (times the spin), so both have the amplitude ε.
  const Vector3d I(1, 2, 3);
  for (const double disturbance : {1e-8, 1e-3}) {
    const Vector3d rate = euler_equations(I, Vector3d(disturbance, 0, 1), Vector3d::Zero());
    CHECK(agrees(rate, Vector3d(0, disturbance, 0), 1e-15, disturbance));
    const Vector3d omega = free_rotation(I, Vector3d(disturbance, 0, 1), VectorXd{{2}});
    CHECK(agrees(omega, Vector3d(disturbance * std::cos(2), disturbance * std::sin(2), 1), integrated));
  }
}

TEST_CASE("Hard arguments: two nearly equal moments behave like two equal ones") {
  const Vector3d omega0(0.3, 0.5, 0.8);
  const VectorXd times{{-3, 12}};
  const Matrix3Xd equal = free_rotation(Vector3d(1, 1, 1.5), omega0, times);
  CHECK(agrees(free_rotation(Vector3d(1, 1 + 1e-9, 1.5), omega0, times), equal, integrated));
  for (int k = 0; k < 2; ++k) {  // the symmetric top of lecture 06: ω₁, ω₂ turn evenly
    const double angle = 0.5 * omega0[2] * times[k];
    const Vector2d turned = Eigen::Rotation2Dd(angle) * Vector2d(omega0.head<2>());
    CHECK(agrees(equal.col(k).head<2>(), turned, integrated));
  }
}
