// Worked examples of lecture 08. Each case is a paragraph of the notes that computes its own numbers.
#include "lectures/support/agrees.hpp"
#include "lectures/support/printed.hpp"

#include <rigid/inertia_tensor.hpp>
#include <rigid/kinetic_energy.hpp>

#include <boost/math/differentiation/autodiff.hpp>
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

namespace autodiff = boost::math::differentiation;
namespace odeint = boost::numeric::odeint;

constexpr double pi = std::numbers::pi;

// The body, attitude and motion of this lecture.
const Vector3d moments(1, 2, 3);
const Vector3d example_angles(0.3, 0.7, 1.1);
const Vector3d example_rates(0.5, -0.2, 0.9);

Matrix3d about(double angle, const Vector3d& axis) { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }

/// A in V_inertial = A V_body, from Eigen's active rotations.
Matrix3d attitude(const Vector3d& angles) {
  return about(angles[0], Vector3d::UnitZ()) * about(angles[1], Vector3d::UnitY()) *
         about(angles[2], Vector3d::UnitZ());
}

/// The three axes about which the angles turn the body, in inertial components: the vertical, the line of nodes, and
/// the body's third axis.
Matrix3d turning_axes(const Vector3d& angles) {
  Matrix3d axes;
  axes << Vector3d::UnitZ(), Vector3d(about(angles[0], Vector3d::UnitZ()) * Vector3d::UnitY()), attitude(angles).col(2);
  return axes;
}

/// E in ω̃ = E q̇.
Matrix3d body_axes_of_rates(const Vector3d& angles) { return attitude(angles).transpose() * turning_axes(angles); }

/// The matrix M of the energy, T = ½ q̇·M q̇: momenta are linear in the rates, p = M q̇.
Matrix3d mass_matrix(const Vector3d& I, const Vector3d& angles) {
  Matrix3d M;
  for (int i = 0; i < 3; ++i) M.col(i) = canonical_momenta(I, angles, Vector3d::Unit(i));
  return M;
}

/// T of the slides for any kind of number, so that it can be differentiated automatically.
template <class Number>
Number energy_of_slides(const Vector3d& I, const std::array<Number, 3>& q, const std::array<Number, 3>& v) {
  const Number first = -v[0] * sin(q[1]) * cos(q[2]) + v[1] * sin(q[2]);
  const Number second = v[0] * sin(q[1]) * sin(q[2]) + v[1] * cos(q[2]);
  const Number third = v[0] * cos(q[1]) + v[2];
  return 0.5 * (I[0] * first * first + I[1] * second * second + I[2] * third * third);
}

/// d/dt ∂L/∂q̇ − ∂L/∂q at given angles, rates and accelerations, by automatic differentiation of the Lagrangian.
template <class Lagrangian>
Vector3d euler_lagrange(const Lagrangian& lagrangian, const Vector3d& angles, const Vector3d& rates,
                        const Vector3d& accelerations) {
  const auto variables = autodiff::make_ftuple<double, 1, 1>(0.0, 0.0);
  const auto& time = std::get<0>(variables);  // moves along the motion
  const auto& step = std::get<1>(variables);  // moves one coordinate or one rate
  using Number = std::remove_cvref_t<decltype(time * step)>;
  Vector3d residual;
  for (int i = 0; i < 3; ++i) {
    std::array<Number, 3> q_moving, v_moving, q_stepped, v_held;
    for (int k = 0; k < 3; ++k) {
      const double here = k == i ? 1 : 0;
      const auto at = static_cast<std::size_t>(k);
      q_moving[at] = angles[k] + rates[k] * time;
      v_moving[at] = rates[k] + accelerations[k] * time + here * step;
      q_stepped[at] = angles[k] + here * step;
      v_held[at] = rates[k];
    }
    residual[i] = lagrangian(q_moving, v_moving).derivative(1, 1) - lagrangian(q_stepped, v_held).derivative(0, 1);
  }
  return residual;
}

/// Angles, and rates where they follow from a law of motion.
struct State {
  Vector3d angles, rates;
};

/// Motion of the angles under given accelerations, by an adaptive Runge–Kutta–Fehlberg method of order 8.
template <class Accelerations>
State moved(const State& start, double duration, const Accelerations& accelerations) {
  using Numbers = std::array<double, 6>;
  Numbers x;
  Vector3d::Map(x.data()) = start.angles;
  Vector3d::Map(x.data() + 3) = start.rates;
  const auto system = [&](const Numbers& now, Numbers& rate, double) {
    const Vector3d angles = Vector3d::Map(now.data()), rates = Vector3d::Map(now.data() + 3);
    Vector3d::Map(rate.data()) = rates;
    Vector3d::Map(rate.data() + 3) = accelerations(angles, rates);
  };
  odeint::integrate_adaptive(odeint::make_controlled(1e-14, 1e-14, odeint::runge_kutta_fehlberg78<Numbers>()), system,
                             x, 0.0, duration, 1e-3 * duration);
  return {Vector3d::Map(x.data()), Vector3d::Map(x.data() + 3)};
}

State moved_freely(const Vector3d& I, const State& start, double duration) {
  return moved(start, duration,
               [&I](const Vector3d& q, const Vector3d& v) { return euler_angle_accelerations(I, q, v); });
}

/// Inertial components of L.
Vector3d momentum_in_space(const Vector3d& I, const State& state) {
  return attitude(state.angles) * I.cwiseProduct(body_axes_of_rates(state.angles) * state.rates);
}

}  // namespace

//! [energy in three ways]
TEST_CASE("The energy of the slides, by the axes in space and by the points of a body") {
  const double T = kinetic_energy_euler(moments, example_angles, example_rates);

  // In space: ω is a sum of three turns, and the tensor of the turned body has all nine entries.
  const Vector3d omega = turning_axes(example_angles) * example_rates;
  CHECK(agrees(T, kinetic_energy(rotated_inertia(moments.asDiagonal(), attitude(example_angles)), omega), 1e-14));

  // Point by point: a cross of four masses of 1 kg in the plane of the first two axes has the moments 1, 2, 3.
  const double half = std::sqrt(0.5);
  const Matrix3Xd r{{1, -1, 0, 0}, {0, 0, half, -half}, {0, 0, 0, 0}};
  CHECK(agrees(inertia_of_points(VectorXd::Ones(4), r), Matrix3d(moments.asDiagonal()), 1e-14));
  const auto places = [&](double t) -> Matrix3Xd { return attitude(example_angles + t * example_rates) * r; };
  const double h = 1e-3;
  const Matrix3Xd velocities = (8 * (places(h) - places(-h)) - (places(2 * h) - places(-2 * h))) / (12 * h);
  CHECK(agrees(T, 0.5 * velocities.squaredNorm(), 1e-11));

  CHECK(agrees(T, 2.55805882913, 1e-11));
  // φ does not enter: turning the whole experiment about the vertical changes nothing.
  CHECK(agrees(kinetic_energy_euler(moments, example_angles + Vector3d(2, 0, 0), example_rates), T, 1e-15));

  Printed page("energy in three ways");
  page.line("T from angles and rates  = {:.12g} J", T);
  page.line("T from four moving masses = {:.10g} J", 0.5 * velocities.squaredNorm());
}
//! [energy in three ways]

//! [symmetric top]
TEST_CASE("For a symmetric top two of the angles disappear from the energy") {
  const double I1 = 2, I3 = 3, theta = 0.7;

  const double T = kinetic_energy_symmetric(I1, I3, theta, example_rates);

  CHECK(agrees(T, 2.610659899, 1e-9));
  // The general formula gives the same for every ψ and every φ.
  for (const double psi : {0.0, 0.4, 1.1, -2.9}) {
    CHECK(agrees(kinetic_energy_euler(Vector3d(I1, I1, I3), Vector3d(-psi, theta, psi), example_rates), T, 1e-14));
  }
  // And by ω alone: ½ I₁ |ω|² plus what the third axis has more, with |ω|² from the angle between ê3⁰ and ê3.
  const double along = example_rates[0] * std::cos(theta) + example_rates[2];
  const double squared = example_rates.squaredNorm() + 2 * example_rates[0] * example_rates[2] * std::cos(theta);
  CHECK(agrees(T, 0.5 * I1 * squared + 0.5 * (I3 - I1) * along * along, 1e-14));

  Printed page("symmetric top");
  page.line("T = {:.10g} J for every φ and ψ", T);
}
//! [symmetric top]

//! [blind to the convention]
TEST_CASE("A symmetric top cannot tell z–y–z from z–x–z") {
  // z–x–z angles with the same numbers: the node is the new x axis, so ω has other components.
  const auto energy_zxz = [](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
    const Vector3d omega =
        v[0] * Vector3d(std::sin(q[1]) * std::sin(q[2]), std::sin(q[1]) * std::cos(q[2]), std::cos(q[1])) +
        v[1] * Vector3d(std::cos(q[2]), -std::sin(q[2]), 0) + v[2] * Vector3d::UnitZ();
    return 0.5 * I.dot(omega.cwiseAbs2());
  };

  const Vector3d symmetric(1, 1, 3);
  const double both = kinetic_energy_euler(symmetric, example_angles, example_rates);
  CHECK(agrees(both, energy_zxz(symmetric, example_angles, example_rates), 1e-14));
  CHECK(agrees(both, 2.53878284570, 1e-11));

  const double zyz = kinetic_energy_euler(moments, example_angles, example_rates);
  const double zxz = energy_zxz(moments, example_angles, example_rates);
  CHECK(agrees(zyz, 2.55805882913, 1e-11));
  CHECK(agrees(zxz, 2.59138391583, 1e-11));
  // The mistake looks like another one: first and second moment exchanged.
  CHECK(agrees(zxz, kinetic_energy_euler(Vector3d(2, 1, 3), example_angles, example_rates), 1e-14));
  // Read rightly, the same attitude has other z–x–z angles, and then the energies agree.
  CHECK(agrees(zyz, energy_zxz(moments, example_angles + Vector3d(pi / 2, 0, -pi / 2), example_rates), 1e-14));

  Printed page("blind to the convention");
  page.line("I = (1, 1, 3): z–y–z {:.12g} J, z–x–z {:.12g} J", both,
            energy_zxz(symmetric, example_angles, example_rates));
  page.line("I = (1, 2, 3): z–y–z {:.12g} J, z–x–z {:.12g} J", zyz, zxz);
}
//! [blind to the convention]

//! [momenta]
TEST_CASE("The canonical momenta are components of L along three axes that are not orthogonal") {
  const Vector3d p = canonical_momenta(moments, example_angles, example_rates);

  CHECK(agrees(p, Vector3d(3.262786224, -0.1109379674, 3.847263281), 1e-9));

  // As derivatives of the energy with respect to the rates.
  const auto rates = autodiff::make_ftuple<double, 1, 1, 1>(example_rates[0], example_rates[1], example_rates[2]);
  using Number = std::remove_cvref_t<decltype(std::get<0>(rates) * std::get<1>(rates) * std::get<2>(rates))>;
  const Number T = energy_of_slides<Number>(
      moments, {Number(example_angles[0]), Number(example_angles[1]), Number(example_angles[2])},
      {Number(std::get<0>(rates)), Number(std::get<1>(rates)), Number(std::get<2>(rates))});
  CHECK(agrees(p, Vector3d(T.derivative(1, 0, 0), T.derivative(0, 1, 0), T.derivative(0, 0, 1)), 1e-14));

  // As projections: on the vertical, on the line of nodes, on the body's axis.
  const Vector3d L = momentum_in_space(moments, {example_angles, example_rates});
  CHECK(agrees(p, turning_axes(example_angles).transpose() * L, 1e-14));
  CHECK(agrees(p[0], L.z(), 1e-14));

  // They hold the energy: T = ½ p·q̇. But their squares do not add up to L².
  CHECK(agrees(0.5 * p.dot(example_rates), kinetic_energy_euler(moments, example_angles, example_rates), 1e-14));
  CHECK_FALSE(agrees(p.squaredNorm(), L.squaredNorm(), 0.1));
  // With the angle between the two outer axes in the account they do.
  const double c = std::cos(example_angles[1]), s = std::sin(example_angles[1]);
  CHECK(agrees(std::pow((p[0] - p[2] * c) / s, 2) + p[1] * p[1] + p[2] * p[2], L.squaredNorm(), 1e-14));

  Printed page("momenta");
  page.line("(p_φ, p_θ, p_ψ) = {} kg m²/s", row(p));
  page.line("L in space      = {} kg m²/s", row(L));
}
//! [momenta]

//! [Euler from Lagrange]
TEST_CASE("Lagrange's equations are Euler's equations, projected on the three axes") {
  // At any accelerations, whether the motion is free or not.
  const Vector3d accelerations(0.7, -1.3, 0.4);
  const auto lagrangian = [](const auto& q, const auto& v) { return energy_of_slides(moments, q, v); };
  const Vector3d residual = euler_lagrange(lagrangian, example_angles, example_rates, accelerations);

  // ω̃ and its rate along the motion, the rate by a central difference.
  const auto omega = [&](double t) -> Vector3d {
    return body_axes_of_rates(example_angles + t * example_rates + t * t / 2 * accelerations) *
           (example_rates + t * accelerations);
  };
  const double h = 1e-3;
  const Vector3d omega_rate = (8 * (omega(h) - omega(-h)) - (omega(2 * h) - omega(-2 * h))) / (12 * h);
  const Vector3d torque = moments.cwiseProduct(omega_rate) + omega(0).cross(moments.cwiseProduct(omega(0)));

  CHECK(agrees(residual, body_axes_of_rates(example_angles).transpose() * torque, 1e-10));
  // The equation of ψ is Euler's third equation, word for word.
  const double third = moments[2] * omega_rate[2] + omega(0)[0] * omega(0)[1] * (moments[1] - moments[0]);
  CHECK(agrees(residual[2], third, 1e-10));

  Printed page("Euler from Lagrange");
  page.line("Lagrange: {}", row(residual, "{:.8f}"));
  page.line("Eᵀ Euler: {}", row(body_axes_of_rates(example_angles).transpose() * torque, "{:.8f}"));
}
//! [Euler from Lagrange]

//! [accelerations]
TEST_CASE("Without torque the angles accelerate all the same") {
  const Vector3d accelerations = euler_angle_accelerations(moments, example_angles, example_rates);

  CHECK(agrees(accelerations, Vector3d(-0.5588173177, -0.7029771348, 0.3842135462), 1e-9));
  // They solve Lagrange's equations,
  const auto lagrangian = [](const auto& q, const auto& v) { return energy_of_slides(moments, q, v); };
  CHECK(agrees(euler_lagrange(lagrangian, example_angles, example_rates, accelerations), Vector3d::Zero(), 1e-14, 3));
  // and keep L where it is: with constant accelerations it drifts only with the square of the time.
  const Vector3d L = momentum_in_space(moments, {example_angles, example_rates});
  const auto drift = [&](double t) {
    return (momentum_in_space(moments, {example_angles + t * example_rates + t * t / 2 * accelerations,
                                        example_rates + t * accelerations}) -
            L)
        .norm();
  };
  CHECK(drift(1e-4) <= 1e-7);
  CHECK(agrees(drift(2e-3) / drift(1e-3), 4, 0.01));  // without the right accelerations the ratio would be 2

  Printed page("accelerations");
  page.line("(φ̈, θ̈, ψ̈) = {} rad/s²", row(accelerations));
}
//! [accelerations]

//! [against the attitude]
TEST_CASE("The accelerations, read off a motion that knows no angles") {
  // Euler's equations for ω̃ together with dA/dt = A [ω̃]: no Euler angle is used until the end.
  using Numbers = std::array<double, 12>;
  const auto system = [](const Numbers& now, Numbers& rate, double) {
    const Vector3d omega = Vector3d::Map(now.data());
    const Matrix3d A = Matrix3d::Map(now.data() + 3);
    Vector3d::Map(rate.data()) = moments.cwiseProduct(omega).cross(omega).cwiseQuotient(moments);
    const Matrix3d cross{{0, -omega[2], omega[1]}, {omega[2], 0, -omega[0]}, {-omega[1], omega[0], 0}};
    Matrix3d::Map(rate.data() + 3) = A * cross;
  };
  const auto angles_at = [&](double t) -> Vector3d {
    Numbers x;
    Vector3d::Map(x.data()) = body_axes_of_rates(example_angles) * example_rates;
    Matrix3d::Map(x.data() + 3) = attitude(example_angles);
    if (t != 0) {
      odeint::integrate_adaptive(odeint::make_controlled(1e-15, 1e-15, odeint::runge_kutta_fehlberg78<Numbers>()),
                                 system, x, 0.0, t, t / 4);
    }
    const Matrix3d A = Matrix3d::Map(x.data() + 3);
    return {std::atan2(A(1, 2), A(0, 2)), std::atan2(std::hypot(A(0, 2), A(1, 2)), A(2, 2)),
            std::atan2(A(2, 1), -A(2, 0))};
  };

  const double h = 0.02;
  const Vector3d by_differences =
      (16 * (angles_at(h) + angles_at(-h)) - (angles_at(2 * h) + angles_at(-2 * h)) - 30 * angles_at(0)) / (12 * h * h);

  const Vector3d accelerations = euler_angle_accelerations(moments, example_angles, example_rates);
  CHECK(agrees(accelerations, by_differences, 1e-6));

  Printed page("against the attitude");
  page.line("by the function:    {} rad/s²", row(accelerations, "{:.8f}"));
  page.line("by second differences: {} rad/s²", row(by_differences, "{:.8f}"));
}
//! [against the attitude]

//! [mass matrix]
TEST_CASE("The matrix of the energy is singular where the angles are") {
  for (const double theta : {1.5, 0.7, 0.1, 0.01}) {
    const Vector3d angles(0.3, theta, 1.1);
    const Matrix3d M = mass_matrix(moments, angles), E = body_axes_of_rates(angles);
    CHECK(agrees(M, E.transpose() * moments.asDiagonal() * E, 1e-14));
    CHECK(agrees(M.determinant(), moments.prod() * std::pow(std::sin(theta), 2), 1e-12, moments.prod()));
    // The inverse of E by hand.
    const double s = std::sin(theta), cot = std::cos(theta) / s, sp = std::sin(1.1), cp = std::cos(1.1);
    const Matrix3d inverse{{-cp / s, sp / s, 0}, {sp, cp, 0}, {cot * cp, -cot * sp, 1}};
    CHECK(agrees(inverse * E, Matrix3d::Identity(), 1e-13, 1 / s));
    // The singular values of E are 1 and √(1 ± cos θ): near θ = 0 small errors of ω become large ones of the rates.
    const Vector3d squares = principal_moments(E.transpose() * E);
    CHECK(agrees(squares, Vector3d(1 - std::cos(theta), 1, 1 + std::cos(theta)), 1e-13));
  }

  Printed page("mass matrix");
  for (const double theta : {1.5, 0.1, 0.01}) {
    const Vector3d squares = principal_moments(body_axes_of_rates(Vector3d(0, theta, 0)).transpose() *
                                               body_axes_of_rates(Vector3d(0, theta, 0)));
    page.line("θ = {:4}: det M = {:.6g}, errors may grow {:.4g} times", theta,
              mass_matrix(moments, Vector3d(0, theta, 0)).determinant(), std::sqrt(squares[2] / squares[0]));
  }
}
//! [mass matrix]

//! [conservation]
TEST_CASE("A free motion in Euler angles keeps T and L, and reaches the exact solution") {
  // The asymmetric top of lecture 06, with L along the vertical: then cos θ = I₃ω̃₃/L and ψ = atan2(I₂ω̃₂, −I₁ω̃₁).
  const Vector3d omega(0.1, 1, 0.1), L_body = moments.cwiseProduct(omega);
  const Vector3d angles(0, std::acos(L_body[2] / L_body.norm()), std::atan2(L_body[1], -L_body[0]));
  const State start{angles, body_axes_of_rates(angles).partialPivLu().solve(omega)};
  CHECK(agrees(momentum_in_space(moments, start), L_body.norm() * Vector3d::UnitZ(), 1e-14));

  const double duration = 20;
  const State end = moved_freely(moments, start, duration);

  CHECK(agrees(kinetic_energy_euler(moments, end.angles, end.rates), kinetic_energy_euler(moments, angles, start.rates),
               1e-11));
  CHECK(agrees(canonical_momenta(moments, end.angles, end.rates)[0], L_body.norm(), 1e-11));  // φ is cyclic
  CHECK(agrees(momentum_in_space(moments, end), momentum_in_space(moments, start), 1e-11));
  // Exact solution with elliptic functions and integrals (lecture 06): ω̃ and φ after 20 s.
  CHECK(agrees(body_axes_of_rates(end.angles) * end.rates, Vector3d(0.6760625658002, 0.7435989558382, 0.3987733662439),
               1e-10));
  CHECK(agrees(end.angles[0], 24.258871956344, 1e-11));
  // p_ψ = L̃₃ is not conserved, because ψ is not cyclic for this body.
  CHECK_FALSE(agrees(canonical_momenta(moments, end.angles, end.rates)[2], L_body[2], 0.5));

  Printed page("conservation");
  page.line("φ after 20 s: {:.12g} rad, exactly 24.258871956344", end.angles[0]);
  page.line("T: {:.13g} J at first, {:.13g} J at last", kinetic_energy_euler(moments, angles, start.rates),
            kinetic_energy_euler(moments, end.angles, end.rates));
  page.line("p_ψ: {:.6g} at first, {:.6g} at last (kg m²/s)", L_body[2],
            canonical_momenta(moments, end.angles, end.rates)[2]);
}
//! [conservation]

//! [steady free precession]
TEST_CASE("The free symmetric top precesses steadily: φ̇ = L/I₁, ψ̇ = −Ω") {
  const double I1 = 1, I3 = 1.8;
  const Vector3d I(I1, I1, I3), omega(0.4, 0, 2), L_body = I.cwiseProduct(omega);
  const Vector3d angles(0, std::acos(L_body[2] / L_body.norm()), std::atan2(L_body[1], -L_body[0]));
  const Vector3d rates(L_body.norm() / I1, 0, -omega[2] * (I3 - I1) / I1);

  // With these rates the body has the ω̃ that we wanted, and no angle accelerates.
  CHECK(agrees(body_axes_of_rates(angles) * rates, omega, 1e-14));
  CHECK(agrees(euler_angle_accelerations(I, angles, rates), Vector3d::Zero(), 1e-13, rates.squaredNorm()));
  CHECK(agrees(rates, Vector3d(3.622154055255, 0, -1.6), 1e-12));
  CHECK(agrees(angles[1] * 180 / pi, 6.340191746, 1e-9));
  // All three momenta are conserved now: T does not depend on φ and ψ, and θ does not move.
  const State end = moved_freely(I, {angles, rates}, 10);
  CHECK(agrees(canonical_momenta(I, end.angles, end.rates), canonical_momenta(I, angles, rates), 1e-11));

  Printed page("steady free precession");
  page.line("φ̇ = {:.12g} rad/s, ψ̇ = {:.6g} rad/s at θ = {:.9g}°", rates[0], rates[2], angles[1] * 180 / pi);
}
//! [steady free precession]

//! [laws]
TEST_CASE("Laws at every attitude: upright, nearly upright, ordinary, nearly upside down, upside down") {
  const Vector3d I(1.3, 2, 2.9), rates(0.5, -0.2, 0.9);
  for (const double theta : {0.0, 1e-8, 0.7, pi / 2, pi - 1e-8, pi, -0.7, 4.0}) {
    const Vector3d q(0.3, theta, 1.1);
    const double T = kinetic_energy_euler(I, q, rates);
    const Vector3d p = canonical_momenta(I, q, rates);
    // Energy and momenta are well defined even where the angles are not unique.
    CHECK(agrees(0.5 * p.dot(rates), T, 1e-14));
    const Vector3d omega = turning_axes(q) * rates;
    CHECK(agrees(T, kinetic_energy(rotated_inertia(I.asDiagonal(), attitude(q)), omega), 1e-14));
    // The same attitude has a second set of angles, (φ + π, −θ, ψ − π); nothing physical may change.
    const Vector3d other = q + Vector3d(pi, -2 * theta, -pi);
    const Vector3d mirror(1, -1, 1);
    CHECK(agrees(attitude(other), attitude(q), 1e-15));
    CHECK(agrees(kinetic_energy_euler(I, other, rates.cwiseProduct(mirror)), T, 1e-14));
    CHECK(agrees(canonical_momenta(I, other, rates.cwiseProduct(mirror)), p.cwiseProduct(mirror), 1e-14));
    // Backwards in time: the energy is even in the rates, the momenta are odd.
    CHECK(agrees(kinetic_energy_euler(I, q, -rates), T, 1e-15));
    CHECK(agrees(canonical_momenta(I, q, -rates), -p, 1e-15));

    if (std::sin(theta) == 0 || std::abs(std::sin(theta)) < 1e-15) continue;  // accelerations are singular upright
    const Vector3d a = euler_angle_accelerations(I, q, rates);
    CHECK(agrees(euler_angle_accelerations(I, other, rates.cwiseProduct(mirror)), a.cwiseProduct(mirror), 1e-7));
    CHECK(agrees(euler_angle_accelerations(I, q, -rates), a, 1e-15));
    CHECK(agrees(euler_angle_accelerations(I, q, 3 * rates), 9 * a, 1e-14));  // quadratic in the rates
  }

  // Upright the body knows only the sum of the outer rates, upside down only their difference.
  CHECK(agrees(kinetic_energy_euler(I, Vector3d(0.3, 0, 1.1), Vector3d(0.5, 0, -0.5)), 0, 1e-15, 1));
  CHECK(agrees(kinetic_energy_euler(I, Vector3d(0.3, pi, 1.1), Vector3d(0.5, 0, 0.5)), 0, 1e-15, 1));
  CHECK(agrees(canonical_momenta(I, Vector3d(0.3, 0, 1.1), rates)[0],
               canonical_momenta(I, Vector3d(0.3, 0, 1.1), rates)[2], 1e-15));
}
//! [laws]

//! [V26]
TEST_CASE("V26 Kinetic energy of a quaternion path, from another program's tests") {
  // Emmy, tests of its rigid-body functions: q = (1, 2, 3, 4), q̇ = (2, 3, 4, 5), T = (8B + 2C)/225. The quaternion is
  // not normalised, and need not be: only its direction matters.
  const Vector3d I(1.3, 2.1, 2.9);
  const auto variables = autodiff::make_ftuple<double, 1>(0.0);
  const auto& time = std::get<0>(variables);
  const auto w = 1 + 2 * time, x = 2 + 3 * time, y = 3 + 4 * time, z = 4 + 5 * time;

  // Third row and column of A, up to |q|², and the angles from them.
  const auto A02 = 2 * (x * z + w * y), A12 = 2 * (y * z - w * x), A22 = w * w - x * x - y * y + z * z;
  const auto A20 = 2 * (x * z - w * y), A21 = 2 * (y * z + w * x);
  const auto phi = atan2(A12, A02), theta = atan2(sqrt(A02 * A02 + A12 * A12), A22), psi = atan2(A21, -A20);
  const Vector3d angles(phi.derivative(0), theta.derivative(0), psi.derivative(0));
  const Vector3d rates(phi.derivative(1), theta.derivative(1), psi.derivative(1));
  CHECK(agrees(attitude(angles), Eigen::Quaterniond(1, 2, 3, 4).normalized().toRotationMatrix(), 1e-15));

  const double T = kinetic_energy_euler(I, angles, rates);
  CHECK(agrees(T, (8 * I[1] + 2 * I[2]) / 225, 1e-14));

  Printed page("V26");
  page.line("V26 | (8·2.1 + 2·2.9)/225 = {:.15g} | {:.15g} | 1e-14", (8 * I[1] + 2 * I[2]) / 225, T);
}
//! [V26]

namespace {

/// The heavy symmetric top of Sussman and Wisdom: it stands on its tip, the weight acts at a distance from it.
struct HeavyTop {
  double I1 = 3.28e-4;     ///< kg m²
  double I3 = 6.6e-5;      ///< kg m²
  double weight = 0.0456;  ///< M g l, J
  Vector3d I{I1, I1, I3};

  /// The weight pulls at θ: potential energy M g l cos θ, so the generalised force is M g l sin θ.
  Vector3d accelerations(const Vector3d& q, const Vector3d& v) const {
    return euler_angle_accelerations(I, q, v) + mass_matrix(I, q).ldlt().solve(Vector3d(0, weight * std::sin(q[1]), 0));
  }

  /// Rates of precession at which θ stays: roots of I₁ cos θ φ̇² − I₃ ω̃₃ φ̇ + M g l = 0.
  Vector2d steady_precession(double theta, double omega3) const {
    const double a = I1 * std::cos(theta), b = I3 * omega3;
    const double larger = (b + std::sqrt(b * b - 4 * a * weight)) / 2;  // no digits cancel in the larger root
    return {weight / larger, larger / a};
  }
};

}  // namespace

//! [V49]
TEST_CASE("V49 The heavy top has two steady precessions, a slow and a fast one") {
  // Moments and M g l of Sussman and Wisdom's top; ω̃₃ = 200 rad/s, θ = 30°.
  const HeavyTop top;
  const double theta = pi / 6, omega3 = 200;

  const Vector2d precession = top.steady_precession(theta, omega3);

  CHECK(agrees(precession, Vector2d(3.758542593804, 42.711113219019), 1e-12));
  const auto lagrangian = [&](const auto& q, const auto& v) {
    return energy_of_slides(top.I, q, v) - top.weight * cos(q[1]);
  };
  for (const double rate : precession) {
    const Vector3d q(0.2, theta, -0.7), v(rate, 0, omega3 - rate * std::cos(theta));
    // Lagrange's equations hold with all accelerations zero, θ̈ = 0 among them; the torque is compared with the
    // weight's.
    CHECK(agrees(euler_lagrange(lagrangian, q, v, Vector3d::Zero()), Vector3d::Zero(), 1e-12, top.weight));
    // By the workbook's functions: what the weight adds, the gyroscopic terms take back.
    CHECK(agrees(top.accelerations(q, v), Vector3d::Zero(), 1e-12, v.squaredNorm()));
    // And in motion: half a second later the inclination is the same.
    const State later = moved(
        {q, v}, 0.5, [&](const Vector3d& angles, const Vector3d& rates) { return top.accelerations(angles, rates); });
    CHECK(agrees(later.angles[1], theta, 1e-9));
    CHECK(agrees(later.angles[0], 0.2 + 0.5 * rate, 1e-9));
  }
  // Below a least spin there is no steady precession: the two roots meet.
  const double least = 2 * std::sqrt(top.I1 * top.weight * std::cos(theta)) / top.I3;
  CHECK(agrees(least, 109.061312312, 1e-10));
  const Vector2d meeting = top.steady_precession(theta, least * (1 + 1e-12));
  CHECK(agrees(meeting[0], meeting[1], 1e-5));

  Printed page("V49");
  page.line(
      "V49 | 3.758542593804, 42.711113219019; least spin 109.061312312 rad/s | {:.12f}, {:.12f}; {:.9f} rad/s | 1e-10",
      precession[0], precession[1], least);
}
//! [V49]

//! [nutation]
TEST_CASE("Let go, the heavy top nods: the effective potential tells how far") {
  const HeavyTop top;
  const State start{Vector3d(0, pi / 6, 0), Vector3d(0, 0, 200)};  // held at 30°, spinning, then released
  const Vector3d p = canonical_momenta(top.I, start.angles, start.rates);

  // φ and ψ are cyclic, so p_φ and p_ψ are numbers, and θ moves as if alone in the effective potential.
  const auto effective_potential = [&](double theta) {
    const double across = (p[0] - p[2] * std::cos(theta)) / std::sin(theta);
    return across * across / (2 * top.I1) + p[2] * p[2] / (2 * top.I3) + top.weight * std::cos(theta);
  };
  const double energy = effective_potential(start.angles[1]);
  CHECK(agrees(
      energy,
      kinetic_energy_symmetric(top.I1, top.I3, start.angles[1], start.rates) + top.weight * std::cos(start.angles[1]),
      1e-14));

  // Released at rest the top is at one turning point; with u = cos θ the other one solves a quadratic equation.
  const double u0 = std::cos(start.angles[1]), spin = p[2] * p[2] / (4 * top.I1 * top.weight);
  const double u = spin - std::sqrt(spin * spin - 2 * spin * u0 + 1);
  const double lowest = std::acos(u);
  CHECK(agrees(effective_potential(lowest), energy, 1e-13));

  // Follow the motion in small steps and look how far it gets.
  const auto law = [&](const Vector3d& q, const Vector3d& v) { return top.accelerations(q, v); };
  State now = start;
  double reached = 0;
  for (int step = 0; step < 800; ++step) {
    now = moved(now, 2e-4, law);
    reached = std::max(reached, now.angles[1]);
    const double T = kinetic_energy_euler(top.I, now.angles, now.rates);
    REQUIRE(agrees(T + top.weight * std::cos(now.angles[1]), energy, 1e-10));
  }
  CHECK(reached <= lowest + 1e-9);
  CHECK(agrees(reached, lowest, 1e-5));  // the largest of many moments, not the turning point itself
  CHECK(agrees(canonical_momenta(top.I, now.angles, now.rates),
               Vector3d(p[0], canonical_momenta(top.I, now.angles, now.rates)[1], p[2]), 1e-10));

  Printed page("nutation");
  page.line("p_φ = {:.8g}, p_ψ = {:.8g} kg m²/s stay", p[0], p[2]);
  page.line("θ nods between 30° and {:.4f}°; the motion reached {:.4f}°", lowest * 180 / pi, reached * 180 / pi);
}
//! [nutation]
