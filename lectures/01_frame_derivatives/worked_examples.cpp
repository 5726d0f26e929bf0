// Worked examples of lecture 01. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/result.hpp"

#include <rigid/frame_derivatives.hpp>

#include <cmath>
#include <numbers>

using namespace rigid;
using workbook::agrees;
using workbook::result;
using workbook::result_table;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
const Vector3d x_axis = Vector3d::UnitX(), y_axis = Vector3d::UnitY(), z_axis = Vector3d::UnitZ();
const Matrix3d one = Matrix3d::Identity();

/// Derivative of a vector or matrix by five points: the error is of fourth order in the step.
template <class Function>
auto derivative(const Function& f, double t) {
  const double h = 1e-3;
  return ((f(t - 2 * h) - 8 * f(t - h) + 8 * f(t + h) - f(t + 2 * h)) / (12 * h)).eval();
}

/// A basis that spins about an axis while that axis rotates about another: nothing about its motion is special, and yet
/// its angular velocity is known in closed form.
struct SpinningAndPrecessing {
  Vector3d spin{0.7, -0.4, 1.1};
  Vector3d precession{0.3, 0.5, -0.2};

  Matrix3d basis(double t) const {
    const Matrix3d start = rotated_basis(one, Vector3d(0.2, 0.5, -0.3), 1);
    return rotated_basis(rotated_basis(start, spin, t), precession, t);
  }
  Vector3d omega(double t) const { return precession + rotated_basis(one, precession, t) * spin; }
};

/// Differences leave rounding errors where a component is zero.
Vector3d cleaned(const Vector3d& v) {
  return v.unaryExpr([&](double x) { return std::abs(x) < 1e-9 * v.norm() ? 0 : x; });
}

/// Components of a vector on the moving basis, as functions of time: any smooth ones will do.
Vector3d any_components(double t) { return {std::cos(t), 0.5 * t * t, std::exp(-t)}; }

/// The rotor of a wind turbine makes 15 revolutions a minute about its shaft, which points along x at the start, while
/// the nacelle follows the wind by half a degree a second.
const Vector3d spin(15 * 2 * pi / 60, 0, 0), yaw(0, 0, 0.5 * degree);  // rad/s
Matrix3d rotor(double t) { return rotated_basis(rotated_basis(one, spin, t), yaw, t); }

}  // namespace

//! [walk]
TEST_CASE("walk: A vector changes because its components do, and because its basis does") {
  //! [walk in brief]
  const Vector3d omega(0, 0, 2 * pi / 12);  // rad/s: one revolution in 12 s
  const auto basis = [&](double t) { return rotated_basis(Matrix3d::Identity(), omega, t); };
  const auto components = [](double t) -> Vector3d { return {1 + 0.5 * t, 0, 0}; };  // m

  // After 3 s, a quarter of a revolution:
  const double t = 3;
  const Vector3d from_components = basis(t) * derivative(components, t);
  const Vector3d from_basis = derivative(basis, t) * components(t);
  //! [walk in brief]

  const auto position = [&](double s) -> Vector3d { return basis(s) * components(s); };
  CHECK(agrees(from_components + from_basis, derivative(position, t), 1e-10));
  CHECK(agrees(from_components, Vector3d(0, 0.5, 0), 1e-10));
  CHECK(agrees(from_basis, Vector3d(-omega.z() * 2.5, 0, 0), 1e-10));

  // The same for a basis and components in general motion.
  const SpinningAndPrecessing frame;
  for (const double s : {-1.3, 0.0, 0.8, 4.1}) {
    const auto moving = [&](double u) { return frame.basis(u); };
    const auto vector = [&](double u) -> Vector3d { return frame.basis(u) * any_components(u); };
    CHECK(agrees(frame.basis(s) * derivative(any_components, s) + derivative(moving, s) * any_components(s),
                 derivative(vector, s), 1e-10));
  }

  result(R"(\sum_i\dot V_i\,\unit e_i)", cleaned(from_components), "m/s",
         "outwards: what the child itself calls its velocity");
  result(R"(\sum_i V_i\,\dot{\unit e}_i)", cleaned(from_basis), "m/s", "what the floor adds");
  result(R"(\dot{\vec V})", cleaned(from_components + from_basis), "m/s", "seen from the ground");
}
//! [walk]

//! [small]
TEST_CASE("small: A rotation by dΘ about x changes e_y by dΘ × e_y, up to second order") {
  Eigen::Matrix3d table;
  int row = 0;
  //! [small in brief]
  for (const double angle : {0.1, 0.01, 0.001}) {
    const Vector3d dTheta(angle, 0, 0);
    const Vector3d change = rotated_basis(Matrix3d::Identity(), dTheta, 1).col(1) - y_axis;
    const double rest = (change - dTheta.cross(y_axis)).norm();
    table.row(row++) << angle, rest, rest / (angle * angle);
  }
  //! [small in brief]

  // The step goes along the tangent instead of the arc: ½ dΘ² is missing, and no part of first order.
  for (int i = 0; i < 3; ++i) CHECK(agrees(table(i, 2), 0.5, 1e-3));
  // All three lines in one: de = dΘ × e, which also says that e_x stays.
  CHECK(agrees(cross_matrix(0.1 * x_axis), Matrix3d{{0, 0, 0}, {0, 0, -0.1}, {0, 0.1, 0}}));
  result_table({R"(\(\dd\Theta\) / rad)", R"(\(|\dd\unit e_y - \dd\vec\Theta\times\unit e_y|\))",
                R"(the same / \(\dd\Theta^2\))"},
               table, 3);
}
//! [small]

//! [cross]
TEST_CASE("cross: ω× is an antisymmetric matrix") {
  //! [cross in brief]
  const Vector3d omega(0.3, -0.2, 0.5);  // rad/s
  const Matrix3d W = cross_matrix(omega);
  const Vector3d v = W * Vector3d(1, 2, -1);  // r in m
  //! [cross in brief]

  CHECK(agrees(W, Matrix3d{{0, -0.5, -0.2}, {0.5, 0, -0.3}, {0.2, 0.3, 0}}));
  CHECK(agrees(v, omega.cross(Vector3d(1, 2, -1)), 1e-15));
  CHECK(agrees(W, -W.transpose()));
  // Applied twice it removes the part along ω and multiplies the rest by −ω².
  CHECK(agrees(W * W, omega * omega.transpose() - omega.squaredNorm() * one, 1e-15));
  // Nothing but the part along ω is lost.
  CHECK(agrees(W * omega, Vector3d::Zero(), 1e-15, 1));
  // Two such matrices do not commute: [a]×[b]× − [b]×[a]× = [a × b]×.
  const Vector3d b(-0.7, 0.4, 0.1);
  CHECK(agrees(W * cross_matrix(b) - cross_matrix(b) * W, cross_matrix(omega.cross(b)), 1e-15, 1));

  result(R"([\vec\omega]_\times)", W, "rad/s", "antisymmetric");
  result(R"([\vec\omega]_\times\vec r)", v, "m/s", "the velocity of that point");
}
//! [cross]

//! [rotor]
TEST_CASE("rotor: The angular velocity of a wind turbine's rotor, from its attitude alone") {
  //! [rotor in brief]
  const double t = 60;  // s
  const Matrix3d A = rotor(t), A_rate = derivative(rotor, t);
  const Vector3d omega = angular_velocity_of_basis(A, A_rate);

  const Vector3d shaft = A.col(0), shaft_rate = A_rate.col(0);
  const Vector3d of_the_shaft = shaft.cross(shaft_rate);
  //! [rotor in brief]

  // Angular velocities add, once the axis of the spin has been rotated to where it is now.
  CHECK(agrees(omega, yaw + rotated_basis(one, yaw, t) * spin, 1e-10));
  CHECK(agrees(of_the_shaft, yaw, 1e-9));
  CHECK(agrees(of_the_shaft, omega - shaft * shaft.dot(omega), 1e-9));
  // A basis in general motion.
  const SpinningAndPrecessing frame;
  for (const double s : {-1.3, 0.0, 0.8, 4.1}) {
    const Matrix3d rate = derivative([&](double u) { return frame.basis(u); }, s);
    CHECK(agrees(angular_velocity_of_basis(frame.basis(s), rate), frame.omega(s), 1e-10));
    // Ȧ Aᵀ is antisymmetric, because A Aᵀ = 1 does not change.
    const Matrix3d W = rate * frame.basis(s).transpose();
    CHECK(agrees(W, -W.transpose(), 1e-10));
  }

  result(R"(\vec\omega)", omega, "rad/s", "the sum of spin and yaw");
  result(R"(\unit e_1\times\dot{\unit e}_1)", cleaned(of_the_shaft), "rad/s",
         "only the yaw: the shaft does not show that it rotates about itself", 4);
}
//! [rotor]

//! [tilde]
TEST_CASE("tilde: One angular velocity, two sets of components") {
  //! [tilde in brief]
  const Matrix3d A = rotor(61), A_rate = derivative(rotor, 61);
  const Matrix3d W = A_rate * A.transpose();       // on inertial axes
  const Matrix3d W_body = A.transpose() * A_rate;  // on the axes of the rotor
  //! [tilde in brief]

  const Vector3d omega = angular_velocity_of_basis(A, A_rate);
  const Vector3d omega_body(W_body(2, 1), W_body(0, 2), W_body(1, 0));
  CHECK(agrees(Vector3d(W(2, 1), W(0, 2), W(1, 0)), omega, 1e-9));
  CHECK(agrees(omega_body, A.transpose() * omega, 1e-9));
  CHECK(agrees(omega_body.norm(), omega.norm(), 1e-9));
  CHECK((omega_body - omega).norm() > 0.1);  // confusing the two is not a small error
  // On the rotor the shaft is always the first axis, and the yaw goes round at the rate of the spin.
  CHECK(agrees(omega_body, Vector3d(spin.x(), yaw.z(), 0), 1e-9));

  result(R"(\vec\omega_\inertialframe)", omega, "rad/s", "on axes at rest");
  result(R"(\vec\omega_\bodyframe)", cleaned(omega_body), "rad/s",
         "the yaw now lies along the blade that is the second axis");
}
//! [tilde]

//! [star]
TEST_CASE(
    "star: A vector fixed among the stars moves for the Earth, and one painted on the Earth moves for the stars") {
  //! [star in brief]
  const Vector3d Omega_earth(0, 0, 7.292115e-5);                 // rad/s
  const Vector3d star(1, 0, 0);                                  // on the celestial equator
  const Vector3d seen = -Omega_earth.cross(star);                // its rate for the Earth
  const Vector3d rate = inertial_rate(seen, Omega_earth, star);  // zero
  //! [star in brief]

  CHECK(agrees(rate, Vector3d::Zero(), 0, 1));
  // Fixed to the frame: the body sees no change, and ω × V is left; perpendicular to V, so that its length stays.
  const Vector3d omega(0.3, -0.2, 0.5), V(1, 2, -1);
  CHECK(agrees(inertial_rate(Vector3d::Zero(), omega, V), omega.cross(V), 1e-15));
  CHECK(agrees(V.dot(omega.cross(V)), 0, 1e-15, 1));
  CHECK(agrees(inertial_rate(Vector3d(0.4, -0.3, 0.6), omega, V), Vector3d(-0.4, 0.5, 1.4), 1e-14));

  const SpinningAndPrecessing frame;
  for (const double t : {-1.3, 0.0, 0.8, 4.1}) {
    const Matrix3d A = frame.basis(t);
    // The theorem makes no use of this number: what the inertial observer measures.
    const Vector3d measured = derivative([&](double s) -> Vector3d { return frame.basis(s) * any_components(s); }, t);
    const Vector3d by_theorem = inertial_rate(A * derivative(any_components, t), frame.omega(t), A * any_components(t));
    CHECK(agrees(by_theorem, measured, 1e-10));
    // On the axes of the body it is the same statement: rotate every argument back, and the result goes along.
    CHECK(agrees(inertial_rate(derivative(any_components, t), A.transpose() * frame.omega(t), any_components(t)),
                 A.transpose() * by_theorem, 1e-12));
    // A fixed vector as the body sees it.
    const Vector3d V_seen = A * derivative([&](double s) -> Vector3d { return frame.basis(s).transpose() * V; }, t);
    CHECK(agrees(inertial_rate(V_seen, frame.omega(t), V), Vector3d::Zero(), 1e-9, 1));
  }

  result(R"(|\dot{\vec V}|_\bodyframe)", seen.norm() / degree * 3600, "arc seconds per second",
         "westwards: 15° an hour, and a little more", 4);
}
//! [star]

//! [cube]
TEST_CASE("cube: A cube rotated by 120° about its diagonal looks the same") {
  //! [cube in brief]
  const Vector3d n = Vector3d::Ones().normalized();
  const double angle = 120 * degree;
  const Matrix3d A = rotated_basis(Matrix3d::Identity(), n, angle);

  Matrix3d power = Matrix3d::Identity(), series = Matrix3d::Identity();
  for (int k = 1; k < 25; ++k) {
    power *= cross_matrix(n) * angle / k;
    series += power;
  }
  //! [cube in brief]

  CHECK(agrees(A, series, 1e-14));
  CHECK(agrees(A, Matrix3d{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, 1e-15));
  result(R"(\mat A)", A, "", R"(\(\unit x\to\unit y\to\unit z\to\unit x\); the series gives the same)");
}
//! [cube]

//! [angles]
TEST_CASE("angles: The rotation is right at the angle 0, at 1e-8, next to half a revolution, and beyond a full one") {
  const Vector3d omega(0.3, -0.2, 0.5);
  const Matrix3d E = SpinningAndPrecessing().basis(0);
  const Vector3d n = omega.normalized();
  const Matrix3d N = cross_matrix(n);
  for (const double angle : {0.0, 1e-8, 0.7, pi - 1e-8, pi, pi + 1e-8, 2 * pi, -2.5, 40.0}) {
    CAPTURE(angle);
    const Matrix3d after = rotated_basis(E, n, angle);
    // It stays a right-handed orthonormal basis.
    CHECK(agrees(after.transpose() * after, one, 1e-14));
    CHECK(agrees(after.determinant(), 1, 1e-14));
    // Rodrigues' formula written out, and Eigen's AngleAxis.
    CHECK(agrees(after, (one + std::sin(angle) * N + (1 - std::cos(angle)) * N * N) * E, 1e-14));
    CHECK(agrees(after, Eigen::AngleAxisd(angle, n).toRotationMatrix() * E, 1e-14));
    // Two halves make a whole, and the way back undoes the way there.
    CHECK(agrees(rotated_basis(rotated_basis(E, n, angle / 2), n, angle / 2), after, 1e-14));
    CHECK(agrees(rotated_basis(after, n, -angle), E, 1e-14));
    // Only the product of ω and dt counts.
    CHECK(agrees(rotated_basis(E, -2 * n, -angle / 2), after, 1e-14));
    // The axis stays where it is, and the basis carries its angular velocity with it.
    CHECK(agrees(after * (E.transpose() * n), n, 1e-14));
    CHECK(agrees(angular_velocity_of_basis(after, cross_matrix(omega) * after), omega, 1e-14));
  }
  // Half a revolution is its own way back.
  CHECK(agrees(rotated_basis(one, n, pi), 2 * n * n.transpose() - one, 1e-15));
  // Nothing rotates without angular velocity.
  CHECK(agrees(rotated_basis(E, Vector3d::Zero(), 5.0), E, 0.0));
  CHECK(agrees(rotated_basis(E, omega, 0.0), E, 1e-15));
  CHECK(agrees(angular_velocity_of_basis(E, Matrix3d::Zero()), Vector3d::Zero(), 0.0, 1));
  // So slow that ω² underflows: the axis must still be found, and a long time still makes an ordinary angle.
  CHECK(agrees(rotated_basis(E, 1e-200 * omega, 0.8e200), rotated_basis(E, omega, 0.8), 1e-14));
  // At 1e-8 the first order is all there is in double precision.
  CHECK(agrees(rotated_basis(E, 1e-8 * omega, 1.0) - E, cross_matrix(1e-8 * omega) * E, 1e-15, 1));
}
//! [angles]

//! [steps]
TEST_CASE("steps: First-order steps leave the circle, however small they are") {
  Eigen::Matrix<double, 4, 2> table;
  int row = 0;
  //! [steps in brief]
  for (const int n : {12, 100, 1000, 10000}) {
    const Vector3d dTheta = 2 * pi / n * z_axis;  // one revolution in n steps
    Vector3d e = x_axis;
    for (int k = 0; k < n; ++k) e += dTheta.cross(e);
    table.row(row++) << n, e.norm();
  }
  //! [steps in brief]

  // Each step goes along the tangent, so it makes e longer by the factor √(1 + dΘ²).
  for (const auto& [n, length] : {std::pair{12.0, table(0, 1)}, {100.0, table(1, 1)}, {1000.0, table(2, 1)}})
    CHECK(agrees(length, std::pow(1 + std::pow(2 * pi / n, 2), n / 2), 1e-12));
  // The exact steps return.
  Matrix3d exact = one;
  for (int k = 0; k < 1000; ++k) exact = rotated_basis(exact, 2 * pi * z_axis, 1e-3);
  CHECK(agrees(exact, one, 1e-12));
  result_table({"steps", "length after one revolution"}, table, 4);
}
//! [steps]

//! [book]
TEST_CASE("book: A book rotated about x and z, in both orders") {
  Eigen::Matrix<double, 3, 3> table;
  int row = 0;
  //! [book in brief]
  for (const double angle : {90.0, 9.0, 0.9}) {
    const Vector3d x(angle * degree, 0, 0), z(0, 0, angle * degree);
    const Matrix3d x_then_z = rotated_basis(rotated_basis(Matrix3d::Identity(), x, 1), z, 1);
    const Matrix3d z_then_x = rotated_basis(rotated_basis(Matrix3d::Identity(), z, 1), x, 1);
    const Eigen::AngleAxisd apart(x_then_z * z_then_x.transpose());
    table.row(row++) << angle, apart.angle() / degree, apart.angle() / x.squaredNorm();
  }
  //! [book in brief]

  CHECK(agrees(table(0, 1), 120, 1e-12));
  CHECK(agrees(table(2, 2), 1, 1e-3));
  // To second order the two differ by a rotation about the cross product of their axes.
  const double a = 1e-3;
  const Matrix3d difference = rotated_basis(rotated_basis(one, a * x_axis, 1), a * z_axis, 1) -
                              rotated_basis(rotated_basis(one, a * z_axis, 1), a * x_axis, 1);
  CHECK(agrees(difference, a * a * cross_matrix(z_axis.cross(x_axis)), 2e-3));
  // Nor is a rotation about ω that about its three components one after the other; the difference is of second order.
  const auto defect = [](double dt) {
    const Vector3d omega(0.3, -0.2, 0.5);
    Matrix3d E = one;
    for (int i = 0; i < 3; ++i) E = rotated_basis(E, omega[i] * Vector3d::Unit(i), dt);
    return (E - rotated_basis(one, omega, dt)).norm();
  };
  CHECK(agrees(defect(0.02) / defect(0.01), 4.0, 0.01));
  CHECK(defect(1.0) > 0.1);

  result_table({"each rotation / °", "difference / °", "difference / product of the angles"}, table, 4);
}
//! [book]

//! [screw]
TEST_CASE("screw: A book put on a shelf: one rotation about an axis and one shift along it") {
  //! [screw in brief]
  const double angle = 90 * degree;
  const Vector3d n = Vector3d::UnitZ(), d(0.4, 0.2, 1.1);  // m: from table to shelf
  const Vector3d along = n * n.dot(d), across = d - along;
  const Vector3d c = 0.5 * (across + n.cross(across) / std::tan(angle / 2));
  //! [screw in brief]

  // Points of the axis move along it only: A c + d = c + (n·d) n.
  const Matrix3d A = rotated_basis(one, n, angle);
  for (const double height : {-2.0, 0.0, 5.0}) CHECK(agrees(A * (c + height * n) + d, c + height * n + along, 1e-14));
  // Any other axis and angle.
  const Vector3d m = Vector3d(2, -1, 2).normalized(), shift(0.3, -0.7, 0.2);
  const Vector3d part = shift - m * m.dot(shift);
  const Vector3d foot = 0.5 * (part + m.cross(part) / std::tan(1.1 / 2));
  CHECK(agrees(rotated_basis(one, m, 1.1) * foot + shift, foot + m * m.dot(shift), 1e-14));

  result(R"(\vec c)", c, "m", "a point of the axis, which is vertical");
  result(R"(\hat{\vec n}\cdot\vec d)", n.dot(d), "m", "the shift along it");
}
//! [screw]

//! [list]
TEST_CASE("list: The slides' matrix acts on the list of basis vectors; its transpose rotates components") {
  //! [list in brief]
  const double cosine = std::cos(30 * degree), sine = std::sin(30 * degree);
  const Eigen::Matrix2d slides{{cosine, sine}, {-sine, cosine}};
  const Eigen::Vector2d V(1, 0);  // V_y, V_z: along the y axis
  const Eigen::Vector2d rotated_vector = slides.transpose() * V;
  const Eigen::Vector2d rotated_axes = slides * V;
  //! [list in brief]

  const Matrix3d basis = rotated_basis(one, x_axis, 30 * degree);
  // The list (e_y, e_z)ᵀ has vectors for entries. Written as numbers, every vector fills a row of it.
  CHECK(agrees(slides * one.bottomRows<2>(), basis.transpose().bottomRows<2>(), 1e-15));
  // A vector that rotates along, on axes that stay; and a vector that stays, on axes that rotate.
  CHECK(agrees((basis * y_axis).tail<2>(), rotated_vector, 1e-15));
  CHECK(agrees((basis.transpose() * y_axis).tail<2>(), rotated_axes, 1e-15));

  result("(V_y, V_z)", rotated_vector, "", "if the vector rotates and the axes stay", 4);
  result("(V_y', V_z')", rotated_axes, "", "if the axes rotate and the vector stays", 4);
}
//! [list]
