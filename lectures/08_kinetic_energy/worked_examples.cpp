// Worked examples of lecture 08. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/motion.hpp"
#include "lectures/support/result.hpp"

#include <rigid/euler_angles.hpp>
#include <rigid/inertia_tensor.hpp>
#include <rigid/kinetic_energy.hpp>

#include <boost/math/differentiation/autodiff.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <array>
#include <cmath>
#include <numbers>

using namespace rigid;
using workbook::agrees;
using workbook::AngleMotion;
using workbook::result;
using workbook::result_table;

namespace {

namespace autodiff = boost::math::differentiation;

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

Matrix3d about(double angle, const Vector3d& axis) { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }

/// A in V_inertial = A V_body, from Eigen's active rotations.
Matrix3d attitude(const Vector3d& angles) {
  return about(angles[0], Vector3d::UnitZ()) * about(angles[1], Vector3d::UnitY()) *
         about(angles[2], Vector3d::UnitZ());
}

/// The axes of the three rates as columns, in inertial components: the vertical, the line of nodes, the body's axis.
Matrix3d axes_of_rates(const Vector3d& angles) {
  Matrix3d axes;
  axes << Vector3d::UnitZ(), Vector3d(about(angles[0], Vector3d::UnitZ()) * Vector3d::UnitY()), attitude(angles).col(2);
  return axes;
}

/// B in ω̃ = B q̇: the same axes in body components.
Matrix3d rate_matrix(const Vector3d& angles) { return attitude(angles).transpose() * axes_of_rates(angles); }

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

AngleMotion moved_freely(const Vector3d& I, const AngleMotion& start, double duration) {
  return workbook::integrated(
      start, duration, [&I](const Vector3d& q, const Vector3d& v) { return euler_angle_accelerations(I, q, v); });
}

/// Inertial components of L.
Vector3d momentum_in_space(const Vector3d& I, const AngleMotion& state) {
  return attitude(state.angles) * I.cwiseProduct(rate_matrix(state.angles) * state.rates);
}

}  // namespace

//! [energy]
TEST_CASE("energy: From the angles and their rates, on the axes of the body and on axes at rest") {
  //! [energy in brief]
  const Vector3d I(1.21e-3, 16.38e-3, 17.48e-3);          // kg m²: a tennis racket
  const Vector3d angles(0.3, 0.7, 1.1), rates(5, -2, 9);  // rad, rad/s
  const double T = kinetic_energy_euler(I, angles, rates);

  const Matrix3d A = rotation_matrix(angles).transpose();
  const Matrix3d I_inertial = rotated_inertia(I.asDiagonal(), A);
  const Vector3d omega = angular_velocity_inertial(angles, rates);
  const double T_inertial = kinetic_energy(I_inertial, omega);
  //! [energy in brief]

  CHECK(agrees(T, T_inertial, 1e-14));
  CHECK(agrees(omega, axes_of_rates(angles) * rates, 1e-14));
  CHECK(agrees(A, attitude(angles), 1e-14));
  // Point by point: a cross of four masses of 1 kg in the plane of the first two axes has the moments 1, 2, 3.
  const Vector3d moments(1, 2, 3);
  const double half = std::sqrt(0.5);
  const Matrix3Xd r{{1, -1, 0, 0}, {0, 0, half, -half}, {0, 0, 0, 0}};
  CHECK(agrees(inertia_of_points(VectorXd::Ones(4), r), Matrix3d(moments.asDiagonal()), 1e-14));
  const auto places = [&](double t) -> Matrix3Xd { return attitude(angles + t * rates) * r; };
  const double h = 1e-4;
  const Matrix3Xd velocities = (8 * (places(h) - places(-h)) - (places(2 * h) - places(-2 * h))) / (12 * h);
  CHECK(agrees(kinetic_energy_euler(moments, angles, rates), 0.5 * velocities.squaredNorm(), 1e-10));
  CHECK(agrees(kinetic_energy_euler(moments, angles, rates / 10), 2.55805882913, 1e-11));
  // φ does not enter: rotating the whole experiment about the vertical changes nothing.
  CHECK(agrees(kinetic_energy_euler(I, angles + Vector3d(2, 0, 0), rates), T, 1e-15));

  result("T", T, "J", "and the same on the axes at rest");
}
//! [energy]

//! [symmetric]
TEST_CASE("symmetric: For a symmetric top two of the angles disappear from the energy") {
  //! [symmetric in brief]
  const double I1 = 3.28e-4, I3 = 6.6e-5;  // kg m²: a toy top, about its tip
  const double theta = 30 * degree;
  const Vector3d rates(4, 0, 200);  // rad/s
  const double T = kinetic_energy_symmetric(I1, I3, theta, rates);
  //! [symmetric in brief]

  for (const double psi : {0.0, 0.4, 1.1, -2.9})
    CHECK(agrees(kinetic_energy_euler(Vector3d(I1, I1, I3), Vector3d(-psi, theta, psi), rates), T, 1e-14));
  // By ω alone: ½ I₁ |ω|² and what the third axis has more, with |ω|² from the angle between the vertical and the axis.
  const Vector3d other(0.5, -0.2, 0.9);
  const double along = other[0] * std::cos(0.7) + other[2];
  const double squared = other.squaredNorm() + 2 * other[0] * other[2] * std::cos(0.7);
  CHECK(agrees(kinetic_energy_symmetric(2, 3, 0.7, other), 0.5 * 2 * squared + 0.5 * (3 - 2) * along * along, 1e-14));
  CHECK(agrees(kinetic_energy_symmetric(2, 3, 0.7, other), 2.610659899, 1e-9));

  result("T", T, "J", R"(for every \(\phi\) and \(\psi\))");
}
//! [symmetric]

//! [convention]
TEST_CASE("convention: A symmetric top cannot tell z–y–z from z–x–z") {
  //! [convention in brief]
  const Vector3d racket(1.21e-3, 16.38e-3, 17.48e-3);     // kg m²
  const Vector3d ball(8e-3, 8e-3, 4e-3);                  // a rugby ball
  const Vector3d angles(0.3, 0.7, 1.1), rates(5, -2, 9);  // rad, rad/s
  const Vector3d omega = angular_velocity_body(angles, rates);
  const Vector3d omega_zxz(omega[1], -omega[0], omega[2]);
  const auto T = [](const Vector3d& I, const Vector3d& w) {
    const Vector3d squares = w.cwiseAbs2();
    return 0.5 * I.dot(squares);
  };
  //! [convention in brief]

  // z–x–z angles with the same numbers, written out.
  const auto written_out = [](const Vector3d& q, const Vector3d& v) -> Vector3d {
    return v[0] * Vector3d(std::sin(q[1]) * std::sin(q[2]), std::sin(q[1]) * std::cos(q[2]), std::cos(q[1])) +
           v[1] * Vector3d(std::cos(q[2]), -std::sin(q[2]), 0) + v[2] * Vector3d::UnitZ();
  };
  CHECK(agrees(omega_zxz, written_out(angles, rates), 1e-14));
  CHECK(agrees(T(racket, omega), kinetic_energy_euler(racket, angles, rates), 1e-14));
  CHECK(agrees(T(ball, omega), T(ball, omega_zxz), 1e-14));
  // The mistake looks like another one: first and second moment exchanged.
  const Vector3d exchanged(racket[1], racket[0], racket[2]);
  CHECK(agrees(T(racket, omega_zxz), kinetic_energy_euler(exchanged, angles, rates), 1e-14));
  // Converted, the same attitude has the same energy.
  CHECK(agrees(T(racket, written_out(angles + Vector3d(pi / 2, 0, -pi / 2), rates)), T(racket, omega), 1e-14));

  result("T", Vector2d(T(racket, omega), T(racket, omega_zxz)), "J", "of the racket: z–y–z, z–x–z", 4);
  result(R"(T_{\text{ball}})", Vector2d(T(ball, omega), T(ball, omega_zxz)), "J", "of a rugby ball: z–y–z, z–x–z", 4);
}
//! [convention]

//! [momenta]
TEST_CASE("momenta: The derivatives of T are projections of L on three axes that are not orthogonal") {
  //! [momenta in brief]
  const Vector3d I(1.21e-3, 16.38e-3, 17.48e-3);          // kg m²: a tennis racket
  const Vector3d angles(0.3, 0.7, 1.1), rates(5, -2, 9);  // rad, rad/s
  const Vector3d p = canonical_momenta(I, angles, rates);

  const Vector3d L = I.cwiseProduct(angular_velocity_body(angles, rates));
  const Vector3d vertical = vertical_in_body(angles[1], angles[2]);
  const Vector3d projected(L.dot(vertical), L.dot(line_of_nodes(angles[2])), L[2]);
  //! [momenta in brief]

  CHECK(agrees(p, projected, 1e-14));
  CHECK(agrees(canonical_momenta(Vector3d(1, 2, 3), angles, rates / 10),
               Vector3d(3.262786224, -0.1109379674, 3.847263281), 1e-9));
  // As derivatives of the energy with respect to the rates.
  const auto moving = autodiff::make_ftuple<double, 1, 1, 1>(rates[0], rates[1], rates[2]);
  using Number = std::remove_cvref_t<decltype(std::get<0>(moving) * std::get<1>(moving) * std::get<2>(moving))>;
  const Number T =
      energy_of_slides<Number>(I, {Number(angles[0]), Number(angles[1]), Number(angles[2])},
                               {Number(std::get<0>(moving)), Number(std::get<1>(moving)), Number(std::get<2>(moving))});
  CHECK(agrees(p, Vector3d(T.derivative(1, 0, 0), T.derivative(0, 1, 0), T.derivative(0, 0, 1)), 1e-14));
  // They hold the energy, T = ½ p·q̇. Their squares do not add up to L², unless the angle between the outer axes counts.
  CHECK(agrees(0.5 * p.dot(rates), kinetic_energy_euler(I, angles, rates), 1e-14));
  CHECK_FALSE(agrees(p.squaredNorm(), L.squaredNorm(), 0.1));
  const double c = std::cos(angles[1]), s = std::sin(angles[1]);
  CHECK(agrees(std::pow((p[0] - p[2] * c) / s, 2) + p[1] * p[1] + p[2] * p[2], L.squaredNorm(), 1e-14));
  CHECK(agrees(p[0], momentum_in_space(I, {angles, rates}).z(), 1e-14));

  result(R"((p_\phi,\ p_\theta,\ p_\psi))", p, "kg m²/s");
  result(R"(\sqrt{p_\phi^2 + p_\theta^2 + p_\psi^2})", p.norm(), "kg m²/s", "which is not");
  result("L", L.norm(), "kg m²/s");
}
//! [momenta]

//! [lagrange]
TEST_CASE("lagrange: Lagrange's equations are Euler's, projected on the three axes") {
  //! [lagrange in brief]
  const Vector3d I(1.21e-3, 16.38e-3, 17.48e-3);          // kg m²: a tennis racket
  const Vector3d angles(0.3, 0.7, 1.1), rates(5, -2, 9);  // rad, rad/s
  const Vector3d accelerations(7, -13, 4);                // rad/s²: any, as by a hand
  const auto T = [&](auto& q, auto& v) { return energy_of_slides(I, q, v); };
  // d/dt ∂T/∂q̇ − ∂T/∂q, differentiated automatically:
  const Vector3d Q = euler_lagrange(T, angles, rates, accelerations);
  //! [lagrange in brief]

  // ω̃ and its rate along the motion, the rate by a central difference.
  const auto omega = [&](double t) -> Vector3d {
    return rate_matrix(angles + t * rates + t * t / 2 * accelerations) * (rates + t * accelerations);
  };
  const double h = 1e-4;
  const Vector3d omega_rate = (8 * (omega(h) - omega(-h)) - (omega(2 * h) - omega(-2 * h))) / (12 * h);
  const Vector3d torque = I.cwiseProduct(omega_rate) + omega(0).cross(I.cwiseProduct(omega(0)));
  CHECK(agrees(Q, rate_matrix(angles).transpose() * torque, 1e-9));
  // The equation of ψ is Euler's third equation, word for word.
  CHECK(agrees(Q[2], I[2] * omega_rate[2] + omega(0)[0] * omega(0)[1] * (I[1] - I[0]), 1e-9));

  result(R"((Q_\phi,\ Q_\theta,\ Q_\psi))", 1e3 * Q, "10⁻³ N m", R"(by differentiating \(T\))", 4);
  result(R"(\mat B\T\,\tilde{\vec\tau})", 1e3 * rate_matrix(angles).transpose() * torque, "10⁻³ N m",
         "from Euler's equations", 4);
}
//! [lagrange]

//! [accelerations]
TEST_CASE("accelerations: Without torque the angles accelerate all the same") {
  //! [accelerations in brief]
  const Vector3d racket(1.21e-3, 16.38e-3, 17.48e-3);     // kg m²
  const Vector3d ball(1e-4, 1e-4, 1e-4);                  // a ball
  const Vector3d angles(0.3, 0.7, 1.1), rates(5, -2, 9);  // rad, rad/s
  const Vector3d of_racket = euler_angle_accelerations(racket, angles, rates);
  const Vector3d of_ball = euler_angle_accelerations(ball, angles, rates);
  //! [accelerations in brief]

  const Vector3d moments(1, 2, 3);
  CHECK(agrees(euler_angle_accelerations(moments, angles, rates / 10),
               Vector3d(-0.5588173177, -0.7029771348, 0.3842135462), 1e-9));
  for (const Vector3d& I : {racket, ball, moments}) {
    const Vector3d found = euler_angle_accelerations(I, angles, rates);
    // They solve Lagrange's equations,
    const auto lagrangian = [&](const auto& q, const auto& v) { return energy_of_slides(I, q, v); };
    CHECK(agrees(euler_lagrange(lagrangian, angles, rates, found), Vector3d::Zero(), 1e-13, 100 * I[2]));
    // and keep L where it is: with constant accelerations it drifts only with the square of the time.
    const Vector3d L = momentum_in_space(I, {angles, rates});
    const auto drift = [&](double t) {
      return (momentum_in_space(I, {angles + t * rates + t * t / 2 * found, rates + t * found}) - L).norm();
    };
    CHECK(agrees(drift(2e-4) / drift(1e-4), 4, 0.01));  // without the right accelerations the ratio would be 2
  }

  // A motion without any angle, Euler's equations together with dA/dt = A [ω̃]×; the angles are found at its end.
  const auto angles_at = [&](double t) -> Vector3d {
    const Matrix3d A = workbook::integrated(racket, {rate_matrix(angles) * rates, attitude(angles)}, t).A;
    return {std::atan2(A(1, 2), A(0, 2)), std::atan2(std::hypot(A(0, 2), A(1, 2)), A(2, 2)),
            std::atan2(A(2, 1), -A(2, 0))};
  };
  const double h = 2e-3;
  const Vector3d by_differences =
      (16 * (angles_at(h) + angles_at(-h)) - (angles_at(2 * h) + angles_at(-2 * h)) - 30 * angles_at(0)) / (12 * h * h);
  CHECK(agrees(of_racket, by_differences, 1e-6));

  result(R"((\ddot\phi,\ \ddot\theta,\ \ddot\psi))", of_racket, "rad/s²", "of the racket", 4);
  result(R"((\ddot\phi,\ \ddot\theta,\ \ddot\psi)_{\text{ball}})", of_ball, "rad/s²",
         R"(of a ball, whose \(\vec\omega\) is constant)", 4);
}
//! [accelerations]

//! [singular]
TEST_CASE("singular: What becomes infinite near the vertical, and what does not") {
  const Vector3d I(1.21e-3, 16.38e-3, 17.48e-3);
  //! [singular in brief]
  const Vector3d omega(3, 4, 5);  // rad/s, of the racket, on its axes
  Eigen::MatrixXd table(4, 4);
  for (int row = 0; const double theta : {90.0, 10.0, 1.0, 179.0}) {
    const Vector3d angles(0.3, theta * degree, 1.1);
    const Vector3d rates = euler_angle_rates(angles, omega);
    table.row(row++) << theta, kinetic_energy_euler(I, angles, rates), rates[0],
        euler_angle_accelerations(I, angles, rates)[0];
  }
  //! [singular in brief]

  CHECK(agrees(table.col(1), Eigen::VectorXd::Constant(4, 0.5 * I.dot(omega.cwiseAbs2())), 1e-13));
  for (const double theta : {1.5, 0.7, 0.1, 0.01, 3.1}) {
    const Vector3d angles(0.3, theta, 1.1);
    const Matrix3d M = mass_matrix(I, angles), B = rate_matrix(angles);
    CHECK(agrees(M, B.transpose() * I.asDiagonal() * B, 1e-14));
    CHECK(agrees(M.determinant(), I.prod() * std::pow(std::sin(theta), 2), 1e-12, I.prod()));
    // The inverse of B by hand.
    const double s = std::sin(theta), cot = std::cos(theta) / s, sp = std::sin(1.1), cp = std::cos(1.1);
    const Matrix3d inverse{{-cp / s, sp / s, 0}, {sp, cp, 0}, {cot * cp, -cot * sp, 1}};
    CHECK(agrees(inverse * B, Matrix3d::Identity(), 1e-13, 1 / s));
  }

  result_table({R"(\(\theta\) / °)", R"(\(T\) / J)", R"(\(\dot\phi\) / (rad/s))", R"(\(\ddot\phi\) / (rad/s²))"}, table,
               4);
}
//! [singular]

//! [free]
TEST_CASE("free: A free body in Euler angles keeps T and L, and nods") {
  //! [free in brief]
  const Vector3d I(1, 2, 3), omega(0.1, 1, 0.1);  // kg m², rad/s: a flat body
  const Vector3d L = I.cwiseProduct(omega);
  const double theta = std::acos(L[2] / L.norm()), psi = std::atan2(L[1], -L[0]);
  const Vector3d angles(0, theta, psi);  // L points upwards
  const Vector3d rates = euler_angle_rates(angles, omega);
  const AngleMotion end = moved_freely(I, {angles, rates}, 20);  // s
  const Vector3d p = canonical_momenta(I, end.angles, end.rates);
  //! [free in brief]

  CHECK(agrees(momentum_in_space(I, {angles, rates}), L.norm() * Vector3d::UnitZ(), 1e-14));
  CHECK(agrees(kinetic_energy_euler(I, end.angles, end.rates), 0.5 * L.dot(omega), 1e-11));
  CHECK(agrees(p[0], L.norm(), 1e-11));  // φ is cyclic
  CHECK(agrees(momentum_in_space(I, end), momentum_in_space(I, {angles, rates}), 1e-11));
  CHECK_FALSE(agrees(p[2], L[2], 0.5));  // ψ is not

  // The exact solution with Jacobi's functions gives ω̃₃; T and L then give ω̃₁² and ω̃₂², and dφ/dt = L (2T − I₃ω̃₃²) /
  // (L² − I₃²ω̃₃²). One integral is left.
  const double twice_T = L.dot(omega), L2 = L.squaredNorm();
  const double a2 = std::sqrt((twice_T * I[2] - L2) / (I[1] * (I[2] - I[1])));
  const double a3 = std::sqrt((L2 - twice_T * I[0]) / (I[2] * (I[2] - I[0])));
  const double nu = std::sqrt((I[2] - I[1]) * (L2 - twice_T * I[0]) / I.prod());
  const double k = std::sqrt((I[1] - I[0]) * (twice_T * I[2] - L2) / ((I[2] - I[1]) * (L2 - twice_T * I[0])));
  const double start = boost::math::ellint_1(k, std::asin(omega[1] / a2));
  const auto omega3 = [&](double t) { return a3 * boost::math::jacobi_dn(k, nu * t + start); };
  CHECK(agrees(omega3(0), omega[2], 1e-13));
  CHECK(agrees(I[2] * omega3(20), p[2], 1e-10));
  const auto phi_rate = [&](double t) {
    const double w = I[2] * omega3(t) * omega3(t);
    return std::sqrt(L2) * (twice_T - w) / (L2 - I[2] * w);
  };
  const double phi = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(phi_rate, 0.0, 20.0, 10, 1e-13);
  CHECK(agrees(end.angles[0], phi, 1e-11));
  CHECK(agrees(phi, 24.258871956344, 1e-12));  // and by elliptic integrals of the third kind, to fifty digits

  result(R"(p_\phi)", p[0], "kg m²/s", R"(which is still \(L\))");
  result(R"(p_\psi)", Vector2d(L[2], p[2]), "kg m²/s", "at the start and after 20 s", 4);
  result(R"(\phi(20\,\mathrm s))", end.angles[0], "rad", "", 10);
  result(R"(\int\dot\phi\,\dd t)", phi, "rad", "from the exact solution", 10);
}
//! [free]

// Not on the page: the free symmetric top precesses steadily, and keeps all three momenta.
TEST_CASE("precession: The free symmetric top in Euler angles") {
  const double I1 = 1, I3 = 1.8;
  const Vector3d I(I1, I1, I3), omega(0.4, 0, 2), L = I.cwiseProduct(omega);
  const Vector3d angles(0, std::acos(L[2] / L.norm()), std::atan2(L[1], -L[0]));
  const Vector3d rates(L.norm() / I1, 0, -omega[2] * (I3 - I1) / I1);
  CHECK(agrees(rate_matrix(angles) * rates, omega, 1e-14));
  CHECK(agrees(euler_angle_accelerations(I, angles, rates), Vector3d::Zero(), 1e-13, rates.squaredNorm()));
  const AngleMotion end = moved_freely(I, {angles, rates}, 10);
  CHECK(agrees(canonical_momenta(I, end.angles, end.rates), canonical_momenta(I, angles, rates), 1e-11));
}

// Not on the page.
TEST_CASE("laws: At every attitude, upright and upside down among them") {
  const Vector3d I(1.3, 2, 2.9), rates(0.5, -0.2, 0.9);
  for (const double theta : {0.0, 1e-8, 0.7, pi / 2, pi - 1e-8, pi, -0.7, 4.0}) {
    const Vector3d q(0.3, theta, 1.1);
    const double T = kinetic_energy_euler(I, q, rates);
    const Vector3d p = canonical_momenta(I, q, rates);
    // Energy and momenta are well defined even where the angles are not unique.
    CHECK(agrees(0.5 * p.dot(rates), T, 1e-14));
    const Vector3d omega = axes_of_rates(q) * rates;
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

  // Upright only the sum of the outer rates counts, upside down only their difference.
  CHECK(agrees(kinetic_energy_euler(I, Vector3d(0.3, 0, 1.1), Vector3d(0.5, 0, -0.5)), 0, 1e-15, 1));
  CHECK(agrees(kinetic_energy_euler(I, Vector3d(0.3, pi, 1.1), Vector3d(0.5, 0, 0.5)), 0, 1e-15, 1));
  CHECK(agrees(canonical_momenta(I, Vector3d(0.3, 0, 1.1), rates)[0],
               canonical_momenta(I, Vector3d(0.3, 0, 1.1), rates)[2], 1e-15));
}

// Not on the page: a number that this project did not make.
TEST_CASE("quaternion: Kinetic energy of a path of quaternions, from another program's tests") {
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

  result("T", T, "J");
}
