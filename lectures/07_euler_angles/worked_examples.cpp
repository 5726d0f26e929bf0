// Worked examples of lecture 07. Each case is a paragraph of the notes that computes its own numbers.
#include "lectures/support/agrees.hpp"
#include "lectures/support/printed.hpp"

#include <rigid/euler_angles.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace rigid;
using workbook::agrees;
using workbook::Printed;
using workbook::row;

namespace {

constexpr double pi = std::numbers::pi;

/// The angles and rates of this lecture.
const Vector3d angles(0.3, 0.7, 1.1);  // φ, θ, ψ
const Vector3d rates(0.5, -0.2, 0.9);  // their rates in rad/s

/// The passive elementary matrices of the slides.
Matrix3d about_z(double angle) {
  return Matrix3d{{std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
}
Matrix3d about_y(double angle) {
  return Matrix3d{{std::cos(angle), 0, -std::sin(angle)}, {0, 1, 0}, {std::sin(angle), 0, std::cos(angle)}};
}
Matrix3d about_x(double angle) {
  return Matrix3d{{1, 0, 0}, {0, std::cos(angle), std::sin(angle)}, {0, -std::sin(angle), std::cos(angle)}};
}

/// Three turns about z, x and z: the other convention.
Matrix3d zxz(const Vector3d& of) { return about_z(of[2]) * about_x(of[1]) * about_z(of[0]); }

//! [differences]
/// The body components of ω from the motion of the matrix alone: R dRᵀ/dt is the cross matrix of ω.
Vector3d omega_by_differences(const std::function<Matrix3d(const Vector3d&)>& matrix, const Vector3d& at,
                              const Vector3d& rate) {
  const double dt = 1e-5;
  const Matrix3d R_rate = (matrix(at + dt * rate) - matrix(at - dt * rate)) / (2 * dt);
  const Matrix3d cross = matrix(at) * R_rate.transpose();
  return {cross(2, 1), cross(0, 2), cross(1, 0)};
}
//! [differences]

/// The matrix E with ω = E (φ̇, θ̇, ψ̇): what each rate alone makes, column by column.
Matrix3d rate_matrix(const Vector3d& at) {
  Matrix3d E;
  for (int i = 0; i < 3; ++i) E.col(i) = angular_velocity_body(at, Vector3d::Unit(i));
  return E;
}

/// Angles at which formulas for rotations go wrong, if they do.
const std::vector<Vector3d> hard_angles = {{0, 0, 0},
                                           {0.4, 0, 0.9},
                                           {0.4, 1e-8, 0.9},
                                           {0.4, -1e-8, 0.9},
                                           {0.3, 0.7, 1.1},
                                           {2.5, 1.2, -2.0},
                                           {0.3, pi / 2, 1.1},
                                           {0.4, 3, 0.9},
                                           {0.4, pi - 1e-8, 0.9},
                                           {0.4, pi, 0.9},
                                           {0.4, pi + 1e-8, 0.9},
                                           {0.3, -0.7, 1.1},
                                           {0.3, 4.5, 1.1},
                                           {9, -8, 7}};

}  // namespace

//! [three turns]
TEST_CASE("Three turns, each about an axis of the triad as it stands by then, make R = R_ψ R_θ R_φ") {
  const double phi = angles[0], theta = angles[1], psi = angles[2];

  // On the vectors: take the triad in hand and turn it.
  using Eigen::AngleAxisd;
  Matrix3d triad = Matrix3d::Identity();                      // columns ê₁, ê₂, ê₃ on the inertial axes
  triad = AngleAxisd(phi, Vector3d(triad.col(2))) * triad;    // φ about ê₃⁰
  triad = AngleAxisd(theta, Vector3d(triad.col(1))) * triad;  // θ about the new ê₂′, the line of nodes
  triad = AngleAxisd(psi, Vector3d(triad.col(2))) * triad;    // ψ about the body's own ê₃

  // On the components: one passive matrix per turn; the first to act stands on the right.
  const Matrix3d R = about_z(psi) * about_y(theta) * about_z(phi);

  CHECK(agrees(rotation_matrix(angles), R, 1e-15));
  CHECK(agrees(rotation_matrix(angles), triad.transpose(), 1e-15));  // row i of R: ê_i on the inertial axes
  CHECK(agrees(R,
               Matrix3d{{0.068064579, 0.95392757, -0.29221464},
                        {-0.78523568, 0.23190061, 0.57413154},
                        {0.61544466, 0.19037934, 0.76484219}},
               1e-8));

  // Eigen's rotations are active, and of the turns about the moved axes the last stands on the right: A = Rᵀ.
  const Matrix3d A =
      (AngleAxisd(phi, Vector3d::UnitZ()) * AngleAxisd(theta, Vector3d::UnitY()) * AngleAxisd(psi, Vector3d::UnitZ()))
          .toRotationMatrix();
  CHECK(agrees(A, R.transpose(), 1e-15));

  Printed page("three turns");
  page.line("R(0.3, 0.7, 1.1) =");
  page.matrix(R, "{:12.8f}");
}
//! [three turns]

//! [the order]
TEST_CASE("Of the two orders of the product only R_ψ R_θ R_φ belongs to the other slides") {
  const double phi = angles[0], theta = angles[1], psi = angles[2];
  const auto reversed = [](const Vector3d& of) -> Matrix3d { return about_z(of[0]) * about_y(of[1]) * about_z(of[2]); };

  // Slide 15 gives the vertical on the body axes; it must be R (0, 0, 1).
  const Vector3d slide_15(-std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta));
  CHECK(agrees(rotation_matrix(angles) * Vector3d::UnitZ(), slide_15, 1e-15));
  CHECK((reversed(angles) * Vector3d::UnitZ() - slide_15).norm() > 0.5);

  // Slide 16 gives ω. The reversed product turns with another one, in which φ stands where ψ should.
  const Vector3d omega = omega_by_differences(rotation_matrix, angles, rates);
  const Vector3d omega_reversed = omega_by_differences(reversed, angles, rates);
  CHECK(agrees(omega, angular_velocity_body(angles, rates), 1e-9));
  CHECK(agrees(omega_reversed,
               Vector3d(rates[1] * std::sin(phi) - rates[2] * std::sin(theta) * std::cos(phi),
                        rates[1] * std::cos(phi) + rates[2] * std::sin(theta) * std::sin(phi),
                        rates[0] + rates[2] * std::cos(theta)),
               1e-9));

  // Negating the angles does not undo a rotation: it gives the transpose of the reversed product.
  CHECK(agrees(rotation_matrix(-angles), reversed(angles).transpose(), 1e-15));

  Printed page("the order");
  page.line("R_ψ R_θ R_φ turns with ω = {} rad/s", row(omega, "{:.6f}"));
  page.line("R_φ R_θ R_ψ turns with ω = {} rad/s", row(omega_reversed, "{:.6f}"));
}
//! [the order]

//! [there and back]
TEST_CASE("Rᵀ leads back to the inertial components") {
  const Vector3d V_body(1, 2, 3);
  const Matrix3d R = rotation_matrix(angles);

  const Vector3d V_inertial = inertial_components(V_body, angles);

  // The sum of components times axes; row i of R holds the axis ê_i.
  CHECK(agrees(V_inertial,
               V_body[0] * R.row(0).transpose() + V_body[1] * R.row(1).transpose() + V_body[2] * R.row(2).transpose(),
               1e-15));
  CHECK(agrees(V_inertial, Vector3d(0.3439272022, 1.988866815, 3.150575006), 1e-9));
  CHECK(agrees(R * V_inertial, V_body, 1e-15));
  CHECK(agrees(V_inertial.norm(), V_body.norm(), 1e-15));  // components change, the vector does not

  Printed page("there and back");
  page.line("V on the body axes     = {}", row(V_body));
  page.line("V on the inertial axes = {}", row(V_inertial));
  page.line("length on either       = {:.10g}, {:.10g}", V_body.norm(), V_inertial.norm());
}
//! [there and back]

//! [line of nodes]
TEST_CASE("The line of nodes is the one direction in which both horizontal planes agree") {
  const double phi = angles[0], theta = angles[1], psi = angles[2];

  const Vector3d nodes = line_of_nodes(psi);

  CHECK(agrees(nodes, about_z(psi) * Vector3d::UnitY(), 1e-15));  // slide 14
  CHECK(agrees(nodes, vertical_in_body(theta, psi).cross(Vector3d::UnitZ()) / std::sin(theta),
               1e-15));  // across both verticals
  CHECK(agrees(nodes, Vector3d(0.8912073601, 0.4535961214, 0), 1e-9));
  // On the inertial axes it is the y axis turned by φ: horizontal there as well.
  CHECK(agrees(inertial_components(nodes, angles), Vector3d(-std::sin(phi), std::cos(phi), 0), 1e-15));

  Printed page("line of nodes");
  page.line("ê₂′ on the body axes     = {}", row(nodes));
  page.line("ê₂′ on the inertial axes = {}", row(inertial_components(nodes, angles)));
}
//! [line of nodes]

//! [the vertical]
TEST_CASE("The vertical on the body axes, and what the prime of slide 15 means") {
  const double theta = angles[1], psi = angles[2];

  const Vector3d vertical = vertical_in_body(theta, psi);

  CHECK(agrees(vertical, about_z(psi) * about_y(theta) * Vector3d::UnitZ(), 1e-15));  // slide 15, as a matrix product
  CHECK(agrees(vertical, rotation_matrix(angles).col(2), 1e-15));                     // whatever φ is
  CHECK(agrees(vertical, Vector3d(-0.2922146443, 0.5741315443, 0.7648421873), 1e-9));

  // Slide 15, as a sum: −sin θ ê₁′ + cos θ ê₃. It holds with ê₁′ as it stands after φ and θ …
  const Vector3d after_theta = about_z(psi) * Vector3d::UnitX();
  CHECK(agrees(vertical, -std::sin(theta) * after_theta + std::cos(theta) * Vector3d::UnitZ(), 1e-15));
  // … and fails with ê₁′ as it stands after φ alone, which is where the slides put ê₂′: that axis is horizontal.
  const Vector3d after_phi = about_z(psi) * about_y(theta) * Vector3d::UnitX();
  CHECK(agrees(vertical.dot(after_phi), 0, 1e-15, 1));
  const Vector3d misread = -std::sin(theta) * after_phi + std::cos(theta) * Vector3d::UnitZ();
  CHECK(misread.norm() < 0.7);  // not even a unit vector

  Printed page("the vertical");
  page.line("ê₃⁰ on the body axes   = {}, length {:.6f}", row(vertical, "{:.8f}"), vertical.norm());
  page.line("with ê₁′ taken after φ = {}, length {:.6f}", row(misread, "{:.8f}"), misread.norm());
}
//! [the vertical]

//! [angular velocity]
TEST_CASE("Three rates along three axes add up to the angular velocity") {
  const double theta = angles[1], psi = angles[2];

  const Vector3d omega = angular_velocity_body(angles, rates);

  // The sum of slide 13, with the axes of slides 14 and 15.
  CHECK(agrees(omega,
               rates[0] * vertical_in_body(theta, psi) + rates[1] * line_of_nodes(psi) + rates[2] * Vector3d::UnitZ(),
               1e-15));
  // The motion of the matrix itself, which knows nothing of axes.
  const Vector3d by_differences = omega_by_differences(rotation_matrix, angles, rates);
  CHECK(agrees(omega, by_differences, 1e-9));
  CHECK(agrees(omega, Vector3d(-0.3243487942, 0.1963465479, 1.282421094), 1e-9));

  Printed page("angular velocity");
  page.line("ω from the three axes = {} rad/s", row(omega, "{:.8f}"));
  page.line("ω from R dRᵀ/dt       = {} rad/s", row(by_differences, "{:.8f}"));
}
//! [angular velocity]

//! [angular velocity from outside]
TEST_CASE("On the inertial axes ω has other components and the same length") {
  const double phi = angles[0], theta = angles[1];

  const Vector3d omega = angular_velocity_inertial(angles, rates);

  CHECK(agrees(omega, inertial_components(angular_velocity_body(angles, rates), angles), 1e-14));
  CHECK(agrees(omega, Vector3d(0.6130042385, -0.01972588816, 1.188357969), 1e-9));
  CHECK(agrees(omega.norm(), angular_velocity_body(angles, rates).norm(), 1e-15));
  // A point of the body at r moves with ω × r: differentiate its inertial components.
  const Vector3d r_body(0.2, -0.5, 0.8);
  const double dt = 1e-5;
  const Vector3d velocity =
      (inertial_components(r_body, angles + dt * rates) - inertial_components(r_body, angles - dt * rates)) / (2 * dt);
  CHECK(agrees(velocity, omega.cross(inertial_components(r_body, angles)), 1e-9));

  // It is the body formula with φ and ψ exchanged, but for the sign of the first component.
  const Vector3d exchanged =
      angular_velocity_body(Vector3d(angles[2], theta, phi), Vector3d(rates[2], rates[1], rates[0]));
  CHECK(agrees(omega, Vector3d(-exchanged[0], exchanged[1], exchanged[2]), 1e-15));

  Printed page("angular velocity from outside");
  page.line("ω on the inertial axes = {} rad/s", row(omega, "{:.8f}"));
  page.line("ω on the body axes     = {} rad/s", row(angular_velocity_body(angles, rates), "{:.8f}"));
  page.line("|ω| = {:.8f} rad/s on either", omega.norm());
}
//! [angular velocity from outside]

//! [two conventions]
TEST_CASE("The same three numbers, read z–y–z and z–x–z, are two attitudes") {
  // Converting is easy: the line of nodes is the y′ axis here and the x′ axis there, a quarter turn apart.
  const Vector3d converted = angles + Vector3d(pi / 2, 0, -pi / 2);
  CHECK(agrees(rotation_matrix(angles), zxz(converted), 1e-15));

  // Not converting is an error of the attitude by a rotation with this angle:
  const Matrix3d error = rotation_matrix(angles) * zxz(angles).transpose();
  const double angle = Eigen::AngleAxisd(error).angle() * 180 / pi;
  CHECK(angle > 30);

  // The angular velocities are related all the same: with equal angles ω(z–x–z) = (ω₂, −ω₁, ω₃).
  const Vector3d omega = angular_velocity_body(angles, rates);
  const Vector3d omega_zxz = omega_by_differences(zxz, angles, rates);
  CHECK(agrees(omega_zxz, Vector3d(omega[1], -omega[0], omega[2]), 1e-9));

  Printed page("two conventions");
  page.line("z–y–z (0.3, 0.7, 1.1) is z–x–z {}", row(converted, "{:.6f}"));
  page.line("read as z–x–z without converting, the attitude is off by {:.2f}°", angle);
  page.line("ω, z–y–z: {} rad/s", row(omega, "{:.6f}"));
  page.line("ω, z–x–z: {} rad/s", row(omega_zxz, "{:.6f}"));
}
//! [two conventions]

//! [blind energy]
TEST_CASE("The energy of a symmetric top cannot tell the two conventions apart") {
  const Vector3d zyz_omega = angular_velocity_body(angles, rates);
  const Vector3d zxz_omega = omega_by_differences(zxz, angles, rates);
  const auto energy = [](const Vector3d& I, const Vector3d& omega) { return 0.5 * I.dot(omega.cwiseAbs2()); };

  const Vector3d symmetric(1, 1, 3), asymmetric(1, 2, 3);
  CHECK(agrees(energy(symmetric, zyz_omega), 2.53878284570, 1e-10));
  CHECK(agrees(energy(symmetric, zxz_omega), 2.53878284570, 1e-9));
  CHECK(agrees(energy(asymmetric, zyz_omega), 2.55805882913, 1e-10));
  CHECK(agrees(energy(asymmetric, zxz_omega), 2.59138391583, 1e-9));
  // In the energy the mix-up is the same as exchanging I₁ and I₂.
  CHECK(agrees(energy(asymmetric, zxz_omega), energy(Vector3d(2, 1, 3), zyz_omega), 1e-9));

  Printed page("blind energy");
  page.line("I = (1, 1, 3) kg m²: z–y–z {:.9f} J, z–x–z {:.9f} J", energy(symmetric, zyz_omega),
            energy(symmetric, zxz_omega));
  page.line("I = (1, 2, 3) kg m²: z–y–z {:.9f} J, z–x–z {:.9f} J", energy(asymmetric, zyz_omega),
            energy(asymmetric, zxz_omega));
}
//! [blind energy]

//! [two names]
TEST_CASE("Every attitude has two sets of angles, and outside θ in [0, π] nothing new") {
  // θ → −θ with half a turn of φ and ψ: the same line of nodes with its arrow reversed.
  CHECK(agrees(rotation_matrix(Vector3d(0.3 + pi, -0.7, 1.1 + pi)), rotation_matrix(angles), 1e-15));
  CHECK(agrees(rotation_matrix(Vector3d(0.3 + pi, 2 * pi - 0.7, 1.1 - pi)), rotation_matrix(angles), 1e-15));

  // So an answer with θ in [0, π] exists for every attitude. Here θ = 4.5 is more than half a turn:
  const Vector3d asked(0.3, 4.5, 1.1);
  const Vector3d answered = euler_angles(rotation_matrix(asked));
  CHECK(answered[1] >= 0);
  CHECK(answered[1] <= pi);
  CHECK(agrees(answered[1], 2 * pi - 4.5, 1e-14));
  CHECK(agrees(rotation_matrix(answered), rotation_matrix(asked), 1e-15));

  Printed page("two names");
  page.line("asked    {}", row(asked, "{:.6f}"));
  page.line("answered {}: other angles, the same attitude", row(answered, "{:.6f}"));
}
//! [two names]

//! [recovery]
TEST_CASE("From the matrix back to the angles, at every attitude") {
  CHECK(agrees(euler_angles(rotation_matrix(Vector3d(0.3, 2.4, 1.1))), Vector3d(0.3, 2.4, 1.1),
               1e-14));  // θ beyond a right angle
  CHECK(agrees(euler_angles(rotation_matrix(Vector3d(2.0, 0.7, 1.1))), Vector3d(2.0, 0.7, 1.1),
               1e-14));  // φ beyond a right angle

  for (const Vector3d& hard : hard_angles) {
    CAPTURE(row(hard));
    const Matrix3d R = rotation_matrix(hard);
    const Vector3d found = euler_angles(R);
    CHECK(found[1] >= 0);
    CHECK(found[1] <= pi);
    CHECK(agrees(rotation_matrix(found), R, 4e-15));  // the matrices, not the angles
  }

  // At θ = 0 the answer is one of many: only the sum of φ and ψ was ever there.
  const Vector3d upright = euler_angles(rotation_matrix(Vector3d(0.4, 0, 0.9)));
  CHECK(agrees(upright[0] + upright[2], 1.3, 1e-15));

  Printed page("recovery");
  page.line("(0.4, 0, 0.9) comes back as {}", row(upright));
  page.line("{} attitudes, θ = 0 and π among them: R comes back within 4e-15", hard_angles.size());
}
//! [recovery]

//! [lost digits]
TEST_CASE("Near θ = 0 the obvious formulas lose digits, and then everything") {
  // An arccosine is blind near 1: cos 1e-8 and cos 0 are the same number.
  const Matrix3d tilted = rotation_matrix(Vector3d(0.4, 1e-8, 0.9));
  const double by_arccosine = std::acos(tilted(2, 2));
  const double by_arctangent = euler_angles(tilted)[1];
  CHECK(by_arccosine == 0);
  CHECK(agrees(by_arctangent, 1e-8, 1e-15));

  // A turn of 1.3 about the vertical that came out of a calculation: what should be zero is a rounding error.
  Matrix3d rounded = about_z(1.3);
  rounded(2, 0) = 3e-17;
  rounded(2, 1) = -2e-17;
  rounded(0, 2) = -4e-17;
  rounded(1, 2) = -1e-17;
  // Row and column read separately give two angles that know nothing of each other …
  const Vector3d separately(std::atan2(rounded(2, 1), rounded(2, 0)), 0, std::atan2(rounded(1, 2), -rounded(0, 2)));
  const double error_separately = (rotation_matrix(separately) - rounded).cwiseAbs().maxCoeff();
  // … while ψ taken from the line of nodes makes up for whatever φ came out.
  const Vector3d through_nodes = euler_angles(rounded);
  const double error_through_nodes = (rotation_matrix(through_nodes) - rounded).cwiseAbs().maxCoeff();
  CHECK(error_separately > 0.5);
  CHECK(error_through_nodes <= 1e-15);

  Printed page("lost digits");
  page.line("θ = 1e-8: arccosine {:.3g}, arctangent {:.3g}", by_arccosine, by_arctangent);
  page.line("φ + ψ = 1.3: read separately {:.6f}, through the line of nodes {:.6f}", separately[0] + separately[2],
            through_nodes[0] + through_nodes[2]);
}
//! [lost digits]

//! [rates]
TEST_CASE("From ω back to the rates") {
  const Vector3d omega = angular_velocity_body(angles, rates);

  CHECK(agrees(euler_angle_rates(angles, omega), rates, 1e-14));
  // The other route: solve the three equations.
  const Matrix3d E = rate_matrix(angles);
  CHECK(agrees(euler_angle_rates(angles, omega), E.fullPivLu().solve(omega), 1e-14));
  // The three axes are not orthogonal, so the transpose will not do: φ̇ and ψ̇ overlap by cos θ.
  const Matrix3d overlaps = E.transpose() * E;
  CHECK(agrees(overlaps(0, 2), std::cos(angles[1]), 1e-15));
  CHECK((E.transpose() * omega - rates).norm() > 0.5);

  Printed page("rates");
  page.line("E⁻¹ ω = {} rad/s", row(euler_angle_rates(angles, omega)));
  page.line("Eᵀ ω  = {} rad/s", row(E.transpose() * omega, "{:.6f}"));
}
//! [rates]

//! [gimbal lock]
TEST_CASE("Gimbal lock has a number: the rates are cot(θ/2) times less certain than ω") {
  const auto condition = [](double theta) {
    const Vector3d stretches = Eigen::JacobiSVD<Matrix3d>(rate_matrix(Vector3d(0.3, theta, 1.1))).singularValues();
    return stretches[0] / stretches[2];
  };

  for (const double theta : {1e-3, 0.01, 0.1, 0.7, pi / 2}) {
    CAPTURE(theta);
    const Vector3d at(0.3, theta, 1.1);
    CHECK(agrees(rate_matrix(at).determinant(), -std::sin(theta), 1e-14));
    CHECK(agrees(condition(theta), 1 / std::tan(theta / 2), 1e-9));
    const Matrix3d E = rate_matrix(at);
    const Vector3d squares = Eigen::SelfAdjointEigenSolver<Matrix3d>(E.transpose() * E).eigenvalues();
    CHECK(agrees(squares, Vector3d(1 - std::cos(theta), 1, 1 + std::cos(theta)), 1e-14));
  }
  CHECK(agrees(condition(0.1), 19.98333055489, 1e-11));
  CHECK(agrees(condition(0.01), 199.99833333, 1e-10));

  // What it means: turn at 1 rad/s about the horizontal axis across the line of nodes, the worst direction.
  const auto fastest = [](double theta) {
    const Vector3d across(-std::cos(1.1), std::sin(1.1), 0);
    return euler_angle_rates(Vector3d(0.3, theta, 1.1), across);
  };
  CHECK(agrees(fastest(0.01)[0], 1 / std::sin(0.01), 1e-14));

  Printed page("gimbal lock");
  page.line("θ (rad)   cond E         cot(θ/2)       φ̇ at |ω| = 1 rad/s");
  for (const double theta : {pi / 2, 0.7, 0.1, 0.01}) {
    page.line("{:<8.4g}  {:<13.10g}  {:<13.10g}  {:.6g} rad/s", theta, condition(theta), 1 / std::tan(theta / 2),
              fastest(theta)[0]);
  }
}
//! [gimbal lock]

//! [hard arguments]
TEST_CASE("The laws of rotations hold at every angle, the awkward ones included") {
  for (const Vector3d& hard : hard_angles) {
    CAPTURE(row(hard));
    const Matrix3d R = rotation_matrix(hard);

    CHECK(agrees(R * R.transpose(), Matrix3d::Identity(), 1e-15, 4));
    CHECK(agrees(R.determinant(), 1, 4e-15));
    CHECK(agrees(vertical_in_body(hard[1], hard[2]), R.col(2), 1e-15, 1));
    CHECK(agrees(inertial_components(Vector3d(1, 2, 3), hard), R.transpose() * Vector3d(1, 2, 3), 1e-15, 8));
    CHECK(agrees(inertial_components(line_of_nodes(hard[2]), hard), Vector3d(-std::sin(hard[0]), std::cos(hard[0]), 0),
                 1e-15, 4));
    CHECK(agrees(rotation_matrix(hard), zxz(hard + Vector3d(pi / 2, 0, -pi / 2)), 1e-15, 8));

    // ω exists at every attitude, gimbal lock or not; it is only the way back that fails there.
    const Vector3d omega = angular_velocity_body(hard, rates);
    CHECK(agrees(omega, omega_by_differences(rotation_matrix, hard, rates), 1e-9));
    CHECK(agrees(angular_velocity_inertial(hard, rates), R.transpose() * omega, 1e-15, 4));
    if (std::abs(std::sin(hard[1])) > 1e-3) {
      CHECK(agrees(euler_angle_rates(hard, omega), rates, 1e-12));
    }
  }
}
//! [hard arguments]

//! [symmetric top]
TEST_CASE("A free symmetric top: with the vertical along L, φ̇ = L/I₁ and ψ̇ = −Ω") {
  const Vector3d I(1, 1, 1.8);                                        // kg m²
  const Vector3d omega(0.4 * std::cos(0.3), 0.4 * std::sin(0.3), 2);  // rad/s, on the body axes

  // Choose ê₃⁰ along L. On the body axes that unit vector is (−sin θ cos ψ, sin θ sin ψ, cos θ): read θ and ψ off it.
  const Vector3d L = I.cwiseProduct(omega);
  const double theta = std::acos(L[2] / L.norm());
  const double psi = std::atan2(L[1], -L[0]);
  CHECK(agrees(vertical_in_body(theta, psi), L.normalized(), 1e-14));

  const Vector3d found = euler_angle_rates(Vector3d(0, theta, psi), omega);

  const double precession = omega[2] * (I[2] - I[0]) / I[0];  // Ω of the slides, S1 s8
  CHECK(agrees(found, Vector3d(L.norm() / I[0], 0, -precession), 1e-13, 4));
  CHECK(agrees(found[0], 3.622154055255, 1e-12));
  CHECK(agrees(theta * 180 / pi, 6.340191746, 1e-9));

  // All three rates are constant, so the motion is known for all times. Its L must stand still in the inertial frame.
  for (const double t : {0.0, 0.7, 5.0, -3.0}) {
    CAPTURE(t);
    const Vector3d at = Vector3d(0, theta, psi) + t * found;
    const Vector3d L_body = I.cwiseProduct(angular_velocity_body(at, found));
    CHECK(agrees(inertial_components(L_body, at), Vector3d(0, 0, L.norm()), 1e-13));
  }

  Printed page("symmetric top");
  page.line("θ = {:.6f}°", theta * 180 / pi);
  page.line("rates of φ, θ, ψ: {} rad/s", row(found, "{:.9f}"));
  page.line("L/I₁ = {:.9f} rad/s, Ω = {:.9f} rad/s", L.norm() / I[0], precession);
}
//! [symmetric top]

//! [thrown plate]
TEST_CASE("A thrown plate wobbles twice as fast as it turns, not the other way round") {
  // A flat disc has I₃ = 2 I₁. Thrown with a little wobble it moves freely: θ stays, L stays.
  const auto wobble_over_turn = [](double theta) {
    const Vector3d I(1, 1, 2);
    const Vector3d omega = vertical_in_body(theta, 0.4).cwiseQuotient(I);  // L = 1 along the vertical
    const Vector3d found = euler_angle_rates(Vector3d(0, theta, 0.4), omega);
    return found[0] / (found[0] + found[2]);  // of the tilt, against a mark on the rim
  };

  // Tuleja and others, on Feynman's story of the plate: the ratio tends to 2; at 10° it is 1.97007.
  CHECK(agrees(wobble_over_turn(1e-4), 2, 1e-5));
  CHECK(agrees(wobble_over_turn(10 * pi / 180), 1.97007, 1e-5));
  // By hand: φ̇ = L/I₁ and ψ̇ = −½ φ̇ cos θ.
  CHECK(agrees(wobble_over_turn(0.7), 1 / (1 - 0.5 * std::cos(0.7)), 1e-14));

  Printed page("thrown plate");
  page.line("wobbles per turn at θ = 10°: {:.5f}, as θ → 0: {:.5f}", wobble_over_turn(10 * pi / 180),
            wobble_over_turn(1e-4));
}
//! [thrown plate]
