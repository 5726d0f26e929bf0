// Worked examples of lecture 01. Each case is a paragraph of the notes that computes its own numbers.
#include "lectures/support/agrees.hpp"
#include "lectures/support/printed.hpp"

#include <rigid/frame_derivatives.hpp>

#include <cmath>
#include <numbers>

using namespace rigid;
using workbook::agrees;
using workbook::Printed;
using workbook::row;

namespace {

constexpr double pi = std::numbers::pi;

/// The angular velocity of this lecture, rad/s.
const Vector3d example_omega(0.3, -0.2, 0.5);

/// Turns a vector by the angle |w|·t about w.
Vector3d turned(const Vector3d& vector, const Vector3d& w, double t) {
  return rotated_basis(Matrix3d::Identity(), w, t) * vector;
}

/// The basis of this lecture: turned from the inertial one by the rotation vector (0.2, 0.5, −0.3).
Matrix3d example_basis() { return rotated_basis(Matrix3d::Identity(), Vector3d(0.2, 0.5, -0.3), 1.0); }

/// A basis that spins about an axis while that axis turns about another: nothing about its motion is special, and yet
/// its angular velocity is known in closed form.
struct SpinningAndPrecessing {
  Vector3d spin{0.7, -0.4, 1.1};
  Vector3d precession{0.3, 0.5, -0.2};

  Matrix3d basis(double t) const { return rotated_basis(rotated_basis(example_basis(), spin, t), precession, t); }

  /// Angular velocities add, once the axis of the spin has been turned to where it is now.
  Vector3d omega(double t) const { return precession + turned(spin, precession, t); }
};

/// Derivative by five points: the error is of fourth order in the step.
template <class Function>
auto derivative(const Function& f, double t) {
  const double h = 1e-3;
  return ((f(t - 2 * h) - 8 * f(t - h) + 8 * f(t + h) - f(t + 2 * h)) / (12 * h)).eval();
}

/// Components of a vector on the moving basis, as functions of time: any smooth ones will do.
Vector3d components(double t) { return {std::cos(t), 0.5 * t * t, std::exp(-t)}; }
Vector3d rates_of_components(double t) { return {-std::sin(t), t, -std::exp(-t)}; }

/// Rodrigues' formula, written out.
Matrix3d rodrigues(const Vector3d& n, double angle) {
  const Matrix3d N = cross_matrix(n);
  return Matrix3d::Identity() + std::sin(angle) * N + (1 - std::cos(angle)) * N * N;
}

}  // namespace

//! [two sources of change]
TEST_CASE("A vector on a moving basis changes because its components do, and because the basis does") {
  const SpinningAndPrecessing frame;
  const double t = 0.8;

  // What the inertial observer measures: the vector itself, a moment earlier and a moment later.
  const Vector3d measured = derivative([&](double s) -> Vector3d { return frame.basis(s) * components(s); }, t);

  // Σ V̇ᵢ eᵢ: the basis held still. Σ Vᵢ ėᵢ: the components held still.
  const Vector3d of_components = frame.basis(t) * rates_of_components(t);
  const Matrix3d basis_rate = derivative([&](double s) -> Matrix3d { return frame.basis(s); }, t);
  const Vector3d of_basis = basis_rate * components(t);

  CHECK(agrees(of_components + of_basis, measured, 1e-10));

  Printed page("two sources of change");
  page.line("sum of V̇ᵢ eᵢ   = {}", row(of_components, "{:.6f}"));
  page.line("sum of Vᵢ ėᵢ   = {}", row(of_basis, "{:.6f}"));
  page.line("both together  = {}", row(of_components + of_basis, "{:.6f}"));
  page.line("dV/dt measured = {}", row(measured, "{:.6f}"));
}
//! [two sources of change]

//! [small turn]
TEST_CASE("A small turn by dΘ about x changes e_y by dΘ e_z and e_z by −dΘ e_y, up to second order") {
  const Matrix3d E = Matrix3d::Identity();

  Printed page("small turn");
  page.line("   dΘ     |de_y − dΘ×e_y|   the same / dΘ²");
  for (const double angle : {0.1, 0.05, 0.025}) {
    const Vector3d dTheta(angle, 0, 0);
    const Matrix3d change = rotated_basis(E, dTheta, 1.0) - E;

    // What is left over is the step along the chord instead of the arc: ½ dΘ², and no part of first order.
    const Vector3d left_over_y = Vector3d(change.col(1)) - angle * Vector3d::UnitZ();
    const Vector3d left_over_z = Vector3d(change.col(2)) + angle * Vector3d::UnitY();
    CHECK(agrees(left_over_y.norm() / (angle * angle), 0.5, 1e-3));
    CHECK(agrees(left_over_z.norm() / (angle * angle), 0.5, 1e-3));

    // Both lines in one: de = dΘ × e, which also says that e_x stays.
    CHECK(agrees(cross_matrix(dTheta) * E, Matrix3d{{0, 0, 0}, {0, 0, -angle}, {0, angle, 0}}));
    page.line(" {:5.3f}     {:.4e}        {:.5f}", angle, left_over_y.norm(), left_over_y.norm() / (angle * angle));
  }
}
//! [small turn]

//! [list of basis vectors]
TEST_CASE("The slides' 2×2 matrix acts on the list of basis vectors; its transpose turns components") {
  const double angle = 0.3;
  const Eigen::Matrix2d slides{{std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)}};
  const Matrix3d turned_basis = rotated_basis(Matrix3d::Identity(), Vector3d::UnitX(), angle);

  // The list (e_y, e_z)ᵀ has vectors for entries. Written as numbers, every vector fills a row of it.
  const Eigen::Matrix<double, 2, 3> list_before = Matrix3d::Identity().bottomRows<2>();
  const Eigen::Matrix<double, 2, 3> list_after = turned_basis.transpose().bottomRows<2>();
  CHECK(agrees(slides * list_before, list_after, 1e-15));

  // A vector that turns along, on axes that stay: its components need the transpose.
  const Vector3d V(0, 2, 1);
  CHECK(agrees((turned_basis * V).tail<2>(), slides.transpose() * V.tail<2>(), 1e-15));

  // A vector that stays, on axes that turn: its new components are e'·V, and that is the slides' matrix again.
  CHECK(agrees((turned_basis.transpose() * V).tail<2>(), slides * V.tail<2>(), 1e-15));

  Printed page("list of basis vectors");
  page.line("V = (V_y, V_z) = {}, turn by {} about x", row(V.tail<2>()), angle);
  page.line("V turns, the axes stay: {}", row((turned_basis * V).tail<2>(), "{:.6f}"));
  page.line("V stays, the axes turn: {}", row((turned_basis.transpose() * V).tail<2>(), "{:.6f}"));
}
//! [list of basis vectors]

//! [cross matrix]
TEST_CASE("ω× is an antisymmetric matrix") {
  const Matrix3d W = cross_matrix(example_omega);
  const Vector3d V(1, 2, -1);

  CHECK(agrees(W, Matrix3d{{0, -0.5, -0.2}, {0.5, 0, -0.3}, {0.2, 0.3, 0}}));
  CHECK(agrees(W * V, example_omega.cross(V), 1e-15));
  CHECK(agrees(W, -W.transpose()));

  // Applied twice it takes away the part along ω and multiplies what is left by −ω²: b a·c − c a·b, as a matrix.
  const Matrix3d square =
      example_omega * example_omega.transpose() - example_omega.squaredNorm() * Matrix3d::Identity();
  CHECK(agrees(W * W, square, 1e-15));
  // And it forgets nothing but the part along ω.
  CHECK(agrees(W * example_omega, Vector3d::Zero(), 1e-15, 1));

  Printed page("cross matrix");
  page.line("[ω]× (rad/s) =");
  page.matrix(W);
  page.line("[ω]× V = {}", row(W * V));
}
//! [cross matrix]

//! [transport theorem]
TEST_CASE("The transport theorem, against finite differences of a moving frame") {
  const SpinningAndPrecessing frame;
  for (const double t : {-1.3, 0.0, 0.8, 4.1}) {
    const Vector3d measured = derivative([&](double s) -> Vector3d { return frame.basis(s) * components(s); }, t);

    // All three on inertial axes: the body's rate too, although it is the body that sees it.
    const Matrix3d E = frame.basis(t);
    const Vector3d by_theorem = inertial_rate(E * rates_of_components(t), frame.omega(t), E * components(t));

    CHECK(agrees(by_theorem, measured, 1e-10));

    // On the body's axes it is the same statement: turn every argument back, and the result turns back with them.
    const Vector3d omega_body = E.transpose() * frame.omega(t);
    CHECK(agrees(inertial_rate(rates_of_components(t), omega_body, components(t)), E.transpose() * by_theorem, 1e-13));
  }

  const Vector3d rate = inertial_rate(Vector3d(0.4, -0.3, 0.6), example_omega, Vector3d(1, 2, -1));
  CHECK(agrees(rate, Vector3d(-0.4, 0.5, 1.4), 1e-14));

  Printed page("transport theorem");
  page.line("(0.4, -0.3, 0.6) + ω × (1, 2, -1) = {}", row(rate));
}
//! [transport theorem]

//! [painted and pinned]
TEST_CASE(
    "A vector painted on the frame moves for the inertial observer, and one pinned to the stars moves for the body") {
  const Vector3d V(1, 2, -1);

  // Painted on: the body sees no change, and all that is left is ω × V.
  CHECK(agrees(inertial_rate(Vector3d::Zero(), example_omega, V), example_omega.cross(V), 1e-15));

  // Pinned to the stars: the body must see the rate −ω × V for the inertial one to vanish.
  const SpinningAndPrecessing frame;
  const double t = 0.8;
  const Vector3d seen =
      frame.basis(t) * derivative([&](double s) -> Vector3d { return frame.basis(s).transpose() * V; }, t);
  CHECK(agrees(seen, -frame.omega(t).cross(V), 1e-10));
  CHECK(agrees(inertial_rate(seen, frame.omega(t), V), Vector3d::Zero(), 1e-10, 1));

  // Either way the length of the vector stays, because ω × V is perpendicular to V.
  CHECK(agrees(V.dot(example_omega.cross(V)), 0.0, 1e-15, 1));

  Printed page("painted and pinned");
  page.line("painted on the frame: inertial rate {}", row(inertial_rate(Vector3d::Zero(), example_omega, V)));
  page.line("pinned to the stars:  body's rate   {}", row(seen, "{:.6f}"));
}
//! [painted and pinned]

//! [finite turn]
TEST_CASE("A finite turn by Rodrigues' formula, by Eigen's AngleAxis and by the exponential series") {
  const Matrix3d E = example_basis();
  const double dt = 0.8;
  const double angle = example_omega.norm() * dt;

  const Matrix3d after = rotated_basis(E, example_omega, dt);

  CHECK(agrees(after, rodrigues(example_omega.normalized(), angle) * E, 1e-14));
  CHECK(agrees(after, Eigen::AngleAxisd(angle, example_omega.normalized()).toRotationMatrix() * E, 1e-14));
  // de/dt = [ω]× e has the solution exp([ω]× t) e(0); its series needs no axis and no angle.
  Matrix3d power = Matrix3d::Identity(), series = Matrix3d::Identity();
  for (int k = 1; k < 20; ++k) {
    power = power * cross_matrix(example_omega) * dt / k;
    series += power;
  }
  CHECK(agrees(after, series * E, 1e-14));

  CHECK(agrees(after,
               Matrix3d{{0.90624152, -0.089874224, 0.41309675},
                        {0.22728974, 0.92748427, -0.29683717},
                        {-0.35646273, 0.36289882, 0.86095225}},
               1e-8));
  CHECK(agrees(after.transpose() * after, Matrix3d::Identity(), 1e-14));

  Printed page("finite turn");
  page.line("angle |ω| dt = {:.6f} rad", angle);
  page.line("basis after {} s =", dt);
  page.matrix(after, "{:11.8f}");
}
//! [finite turn]

//! [leaving the circle]
TEST_CASE("A wrong turn: the first-order step leaves the circle, however small it is") {
  // One turn about z in n steps of e ← e + ω × e dt. Each step goes along the tangent, so every step makes e longer
  // by the factor √(1 + dΘ²).
  Printed page("leaving the circle");
  page.line("steps   length after one turn: first order   exact");
  for (const int steps : {12, 100, 1000}) {
    const Vector3d omega = 2 * pi * Vector3d::UnitZ();
    const double dt = 1.0 / steps;
    Vector3d first_order = Vector3d::UnitX();
    Matrix3d exact = Matrix3d::Identity();
    for (int k = 0; k < steps; ++k) {
      first_order += omega.cross(first_order) * dt;
      exact = rotated_basis(exact, omega, dt);
    }

    const double dTheta = 2 * pi / steps;
    CHECK(agrees(first_order.norm(), std::pow(1 + dTheta * dTheta, steps / 2.0), 1e-12));
    CHECK(first_order.norm() > 1.01);
    CHECK(agrees(exact, Matrix3d::Identity(), 1e-12));
    page.line("{:5}   {:.6f}                             {:.6f}", steps, first_order.norm(), exact.col(0).norm());
  }
}
//! [leaving the circle]

//! [order of turns]
TEST_CASE("Small turns may be taken in any order, finite ones may not") {
  // The components of ω dt are no angles about x, y, z taken one after the other: the difference is of second order.
  const auto one_after_the_other = [](double dt) -> Matrix3d {
    const Matrix3d about_x = rotated_basis(Matrix3d::Identity(), example_omega.x() * Vector3d::UnitX(), dt);
    const Matrix3d about_xy = rotated_basis(about_x, example_omega.y() * Vector3d::UnitY(), dt);
    return rotated_basis(about_xy, example_omega.z() * Vector3d::UnitZ(), dt);
  };
  const auto difference = [&](double dt) {
    return (one_after_the_other(dt) - rotated_basis(Matrix3d::Identity(), example_omega, dt)).norm();
  };

  CHECK(agrees(difference(0.02) / difference(0.01), 4.0, 0.01));  // half the time, a quarter of the difference
  CHECK(difference(1.0) > 0.1);

  Printed page("order of turns");
  for (const double dt : {1.0, 0.1, 0.01}) page.line("dt = {:4} s: they differ by {:.3e}", dt, difference(dt));
}
//! [order of turns]

//! [angular velocity]
TEST_CASE("A basis and its rate contain the angular velocity") {
  const Matrix3d E = example_basis();
  const Matrix3d E_rate = cross_matrix(example_omega) * E;

  CHECK(agrees(angular_velocity_of_basis(E, E_rate), example_omega, 1e-14));

  // A basis in general motion, its rate by finite differences: ω comes out as the sum of spin and precession.
  const SpinningAndPrecessing frame;
  for (const double t : {-1.3, 0.0, 0.8, 4.1}) {
    const Matrix3d rate = derivative([&](double s) -> Matrix3d { return frame.basis(s); }, t);
    CHECK(agrees(angular_velocity_of_basis(frame.basis(t), rate), frame.omega(t), 1e-10));
    // What makes it work: Ė Eᵀ is antisymmetric, because E Eᵀ = 1 does not change.
    const Matrix3d W = rate * frame.basis(t).transpose();
    CHECK(agrees(W, -W.transpose(), 1e-10));
  }

  // One basis vector alone knows only the part of ω across itself.
  const Vector3d e = E.col(0);
  CHECK(agrees(e.cross(Vector3d(E_rate.col(0))), example_omega - e * e.dot(example_omega), 1e-14));

  Printed page("angular velocity");
  page.line("ω           = {} rad/s", row(angular_velocity_of_basis(E, E_rate)));
  page.line("e₁ × ė₁     = {} rad/s", row(e.cross(Vector3d(E_rate.col(0))), "{:.6f}"));
}
//! [angular velocity]

//! [tilde]
TEST_CASE("One angular velocity, two sets of components: the slides' tilde") {
  const Matrix3d E = example_basis();
  const Matrix3d E_rate = cross_matrix(example_omega) * E;

  // Ė Eᵀ holds ω on the inertial axes; Eᵀ Ė holds the same vector on the axes of the body.
  const Matrix3d W_body = E.transpose() * E_rate;
  const Vector3d omega_body(W_body(2, 1), W_body(0, 2), W_body(1, 0));

  CHECK(agrees(omega_body, E.transpose() * example_omega, 1e-14));
  CHECK(agrees(omega_body.norm(), example_omega.norm(), 1e-14));
  CHECK((omega_body - example_omega).norm() > 0.1);  // confusing the two is not a small error

  Printed page("tilde");
  page.line("on the inertial axes: ω = {} rad/s", row(example_omega, "{:.6f}"));
  page.line("on the body's axes:   ω̃ = {} rad/s", row(omega_body, "{:.6f}"));
}
//! [tilde]

//! [hard angles]
TEST_CASE("The laws of turning hold at the angle 0, at 1e-8, near half a turn, at half a turn and at a full one") {
  const Matrix3d E = example_basis();
  const Vector3d n = example_omega.normalized();

  for (const double angle : {0.0, 1e-8, 0.7, pi - 1e-8, pi, pi + 1e-8, 2 * pi, -2.5, 40.0}) {
    CAPTURE(angle);
    const Matrix3d after = rotated_basis(E, n, angle);
    // It stays a right-handed orthonormal basis.
    CHECK(agrees(after.transpose() * after, Matrix3d::Identity(), 1e-14));
    CHECK(agrees(after.determinant(), 1, 1e-14));
    // Rodrigues' formula and Eigen's AngleAxis are one and the same.
    CHECK(agrees(after, rodrigues(n, angle) * E, 1e-14));
    CHECK(agrees(after, Eigen::AngleAxisd(angle, n).toRotationMatrix() * E, 1e-14));
    // Two halves make a whole, and the way back undoes the way there.
    CHECK(agrees(rotated_basis(rotated_basis(E, n, angle / 2), n, angle / 2), after, 1e-14));
    CHECK(agrees(rotated_basis(after, n, -angle), E, 1e-14));
    // Only the product of ω and dt counts.
    CHECK(agrees(rotated_basis(E, -2 * n, -angle / 2), after, 1e-14));
    // The axis stays where it is, and the basis carries its angular velocity with it.
    CHECK(agrees(after * (E.transpose() * n), n, 1e-14));
    CHECK(agrees(angular_velocity_of_basis(after, cross_matrix(example_omega) * after), example_omega, 1e-14));
  }
}

TEST_CASE("Nothing turns without angular velocity, and almost nothing with almost none") {
  const Matrix3d E = example_basis();
  CHECK(agrees(rotated_basis(E, Vector3d::Zero(), 5.0), E, 0.0));
  CHECK(agrees(rotated_basis(E, example_omega, 0.0), E, 1e-15));
  CHECK(agrees(angular_velocity_of_basis(E, Matrix3d::Zero()), Vector3d::Zero(), 0.0, 1));
  // So slow that ω² underflows: the axis must still be found, and a long time still turns by an ordinary angle.
  const Vector3d slow = 1e-200 * example_omega;
  CHECK(agrees(rotated_basis(E, slow, 0.8e200), rotated_basis(E, example_omega, 0.8), 1e-14));
  // At 1e-8 the first order is all there is in double precision.
  const Vector3d tiny = 1e-8 * example_omega;
  CHECK(agrees(rotated_basis(E, tiny, 1.0) - E, cross_matrix(tiny) * E, 1e-15, 1));
}

TEST_CASE("Half a turn is its own way back, and reverses whatever is perpendicular to the axis") {
  const Vector3d n = example_omega.normalized();
  const Matrix3d half = rotated_basis(Matrix3d::Identity(), n, pi);
  CHECK(agrees(half, half.transpose(), 1e-15, 1));
  CHECK(agrees(half, 2 * n * n.transpose() - Matrix3d::Identity(), 1e-15));
  CHECK(agrees(half * half, Matrix3d::Identity(), 1e-15));

  Printed page("hard angles");
  page.line("half a turn about ω =");
  page.matrix(half, "{:10.6f}");
}
//! [hard angles]
