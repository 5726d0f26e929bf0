// Worked examples of lecture 07. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/result.hpp"

#include <rigid/euler_angles.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace rigid;
using Eigen::AngleAxisd;
using workbook::agrees;
using workbook::result;
using workbook::result_table;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

const Vector3d x_axis = Vector3d::UnitX(), y_axis = Vector3d::UnitY(), z_axis = Vector3d::UnitZ();

/// The passive matrix of a rotation of the axes, from Eigen's active one.
Matrix3d passive(double angle, const Vector3d& axis) { return AngleAxisd(-angle, axis).toRotationMatrix(); }

/// Rotations about z, x and z: the other convention.
Matrix3d zxz(const Vector3d& of) { return passive(of[2], z_axis) * passive(of[1], x_axis) * passive(of[0], z_axis); }

/// The body components of ω from the motion of the matrix alone: R dRᵀ/dt is the cross matrix of ω.
Vector3d omega_by_differences(const std::function<Matrix3d(const Vector3d&)>& matrix, const Vector3d& at,
                              const Vector3d& rate) {
  const double dt = 1e-5;
  const Matrix3d R_rate = (matrix(at + dt * rate) - matrix(at - dt * rate)) / (2 * dt);
  const Matrix3d cross = matrix(at) * R_rate.transpose();
  return {cross(2, 1), cross(0, 2), cross(1, 0)};
}

/// The matrix B in ω = B (dφ/dt, dθ/dt, dψ/dt): what each rate alone makes, column by column.
Matrix3d rate_matrix(const Vector3d& at) {
  Matrix3d B;
  for (int i = 0; i < 3; ++i) B.col(i) = angular_velocity_body(at, Vector3d::Unit(i));
  return B;
}

}  // namespace

//! [attitude]
TEST_CASE("attitude: Three rotations, each about an axis of the body as it lies by then, make one matrix") {
  //! [attitude in brief]
  const double phi = 0.3, theta = 0.7, psi = 1.1;
  const Matrix3d R = rotation_matrix({phi, theta, psi});

  Matrix3d A = Matrix3d::Identity();  // columns: the body axes
  A = AngleAxisd(phi, Vector3d(A.col(2))) * A;
  A = AngleAxisd(theta, Vector3d(A.col(1))) * A;
  A = AngleAxisd(psi, Vector3d(A.col(2))) * A;
  //! [attitude in brief]

  CHECK(agrees(R, A.transpose(), 1e-15));
  // About fixed axes, in the opposite order; and the passive factors of the slides.
  CHECK(agrees(A, (AngleAxisd(phi, z_axis) * AngleAxisd(theta, y_axis) * AngleAxisd(psi, z_axis)).toRotationMatrix(),
               1e-15));
  CHECK(agrees(R, passive(psi, z_axis) * passive(theta, y_axis) * passive(phi, z_axis), 1e-15));
  CHECK(agrees(passive(phi, z_axis),
               Matrix3d{{std::cos(phi), std::sin(phi), 0}, {-std::sin(phi), std::cos(phi), 0}, {0, 0, 1}}, 1e-15));
  CHECK(agrees(R,
               Matrix3d{{0.068064579, 0.95392757, -0.29221464},
                        {-0.78523568, 0.23190061, 0.57413154},
                        {0.61544466, 0.19037934, 0.76484219}},
               1e-8));

  // The factors in the opposite order belong to another vertical, and rotate with another ω, in which φ stands for ψ.
  const auto reversed = [](const Vector3d& of) -> Matrix3d {
    return passive(of[0], z_axis) * passive(of[1], y_axis) * passive(of[2], z_axis);
  };
  const Vector3d angles(phi, theta, psi), rates(0.5, -0.2, 0.9);
  CHECK((reversed(angles) - R).norm() > 0.5);
  CHECK(agrees(omega_by_differences(reversed, angles, rates),
               angular_velocity_body(Vector3d(psi, theta, phi), rates.reverse()), 1e-9));
  CHECK(agrees(rotation_matrix(-angles), reversed(angles).transpose(), 1e-15));

  result(R"(\mat R)", R, "", "its rows are the body axes");
}
//! [attitude]

//! [thruster]
TEST_CASE("thruster: The transpose gives the components on the inertial axes") {
  //! [thruster in brief]
  const Vector3d angles(0.3, 0.7, 1.1);                // φ, θ, ψ of a satellite
  const Vector3d F_body = 20 * Vector3d(1, 2, 2) / 3;  // N, along a thruster
  const Vector3d F = inertial_components(F_body, angles);
  //! [thruster in brief]

  const Matrix3d R = rotation_matrix(angles);
  CHECK(agrees(F,
               F_body[0] * R.row(0).transpose() + F_body[1] * R.row(1).transpose() + F_body[2] * R.row(2).transpose(),
               1e-14));
  CHECK(agrees(R * F, F_body, 1e-14));
  CHECK(agrees(inertial_components(Vector3d(1, 2, 3), angles), Vector3d(0.3439272022, 1.988866815, 3.150575006), 1e-9));

  result(R"(\vec F_\bodyframe)", F_body, "N", "", 4);
  result(R"(\vec F_\inertialframe)", F, "N", "the same force on other axes", 4);
  result(R"(|\vec F_\inertialframe|)", F.norm(), "N");
}
//! [thruster]

//! [phone]
TEST_CASE("phone: An accelerometer at rest shows the vertical on its own axes") {
  //! [phone in brief]
  const double g = 9.81;                                 // m/s²
  const double theta = 50 * degree, psi = 115 * degree;  // of a leaning phone
  const Vector3d shown = g * vertical_in_body(theta, psi);

  const double theta_found = std::atan2(std::hypot(shown[0], shown[1]), shown[2]);
  const double psi_found = std::atan2(shown[1], -shown[0]);
  const Vector3d nodes = line_of_nodes(psi_found);  // it leans about this axis
  //! [phone in brief]

  CHECK(agrees(Vector2d(theta_found, psi_found), Vector2d(theta, psi), 1e-14));
  // Whatever φ is, the vertical is the third column of R, and the line of nodes is horizontal: y rotated by φ.
  for (const double phi : {0.0, 0.3, 2.0, -3.0}) {
    const Vector3d angles(phi, theta, psi);
    CHECK(agrees(shown, g * rotation_matrix(angles).col(2), 1e-14));
    CHECK(agrees(inertial_components(nodes, angles), Vector3d(-std::sin(phi), std::cos(phi), 0), 1e-14));
  }
  CHECK(agrees(nodes, passive(psi, z_axis) * y_axis, 1e-14));
  CHECK(agrees(nodes, vertical_in_body(theta, psi).cross(z_axis) / std::sin(theta), 1e-14));

  // The sum −sin θ e₁′ + cos θ e₃ holds with e₁′ after φ and θ; with e₁′ after φ alone it is no unit vector.
  const Vector3d after_theta = passive(psi, z_axis) * x_axis;
  const Vector3d after_phi = passive(psi, z_axis) * passive(theta, y_axis) * x_axis;
  CHECK(agrees(shown / g, -std::sin(theta) * after_theta + std::cos(theta) * z_axis, 1e-14));
  CHECK((-std::sin(theta) * after_phi + std::cos(theta) * z_axis).norm() < 0.9);

  result(R"(g\,\unit e^0_3)", shown, "m/s²", "on the axes of the phone", 4);
  result(R"((\theta,\ \psi))", Vector2d(theta_found, psi_found) / degree, "°", "read off it");
  result(R"(\unit e_2')", nodes, "", "on the axes of the phone", 4);
}
//! [phone]

//! [omega]
TEST_CASE("omega: Three rates along three axes add up to the angular velocity") {
  //! [omega in brief]
  const Vector3d angles(0.3, 0.7, 1.1), rates(0.5, -0.2, 0.9);  // rad, rad/s
  const Vector3d omega = angular_velocity_body(angles, rates);

  const auto R = [&](double t) { return rotation_matrix(angles + t * rates); };
  const double dt = 1e-5;                                                 // s
  const Matrix3d cross = R(0) * (R(dt) - R(-dt)).transpose() / (2 * dt);  // [ω]×
  //! [omega in brief]

  CHECK(agrees(
      omega,
      rates[0] * vertical_in_body(angles[1], angles[2]) + rates[1] * line_of_nodes(angles[2]) + rates[2] * z_axis,
      1e-15));
  const Matrix3d expected{{0, -omega[2], omega[1]}, {omega[2], 0, -omega[0]}, {-omega[1], omega[0], 0}};
  CHECK(agrees(cross, expected, 1e-9));
  CHECK(agrees(omega, Vector3d(-0.3243487942, 0.1963465479, 1.282421094), 1e-9));

  result(R"(\tilde{\vec\omega})", omega, "rad/s", "from the rates");
  result(R"((\mat R\,\dot{\mat R}\T)_{32,13,21})", Vector3d(cross(2, 1), cross(0, 2), cross(1, 0)), "rad/s",
         "from the motion of the matrix");
}
//! [omega]

//! [outside]
TEST_CASE("outside: On the inertial axes the same vector has other components") {
  //! [outside in brief]
  const Vector3d angles(0.3, 0.7, 1.1), rates(0.5, -0.2, 0.9);  // rad, rad/s
  const Vector3d omega_inertial = angular_velocity_inertial(angles, rates);
  const Vector3d omega_body = angular_velocity_body(angles, rates);
  //! [outside in brief]

  CHECK(agrees(omega_inertial, inertial_components(omega_body, angles), 1e-14));
  CHECK(agrees(omega_inertial, Vector3d(0.6130042385, -0.01972588816, 1.188357969), 1e-9));
  // A point of the body at r moves with ω × r: differentiate its inertial components.
  const Vector3d r_body(0.2, -0.5, 0.8);
  const double dt = 1e-5;
  const Vector3d velocity =
      (inertial_components(r_body, angles + dt * rates) - inertial_components(r_body, angles - dt * rates)) / (2 * dt);
  CHECK(agrees(velocity, omega_inertial.cross(inertial_components(r_body, angles)), 1e-9));
  // It is the body formula with φ and ψ exchanged, but for the sign of the first component.
  const Vector3d exchanged = angular_velocity_body(angles.reverse(), rates.reverse());
  CHECK(agrees(omega_inertial, Vector3d(-exchanged[0], exchanged[1], exchanged[2]), 1e-15));

  result(R"(\vec\omega_\inertialframe)", omega_inertial, "rad/s");
  result(R"((\omega_\inertialframe,\ \omega_\bodyframe))", Vector2d(omega_inertial.norm(), omega_body.norm()), "rad/s",
         "one length on both sets of axes");
}
//! [outside]

//! [rates]
TEST_CASE("rates: From ω back to the rates, which are no projections") {
  //! [rates in brief]
  const Vector3d angles(0.3, 0.7, 1.1), rates(0.5, -0.2, 0.9);  // rad, rad/s
  const Vector3d omega = angular_velocity_body(angles, rates);
  const Vector3d found = euler_angle_rates(angles, omega);

  const Vector3d vertical = vertical_in_body(angles[1], angles[2]);
  const Vector3d nodes = line_of_nodes(angles[2]);
  const Vector3d projected(omega.dot(vertical), omega.dot(nodes), omega[2]);
  //! [rates in brief]

  CHECK(agrees(found, rates, 1e-14));
  const Matrix3d B = rate_matrix(angles);
  CHECK(agrees(found, B.fullPivLu().solve(omega), 1e-14));
  CHECK(agrees(projected, B.transpose() * omega, 1e-14));
  CHECK((projected - rates).norm() > 0.5);

  result(R"((\dot\phi,\ \dot\theta,\ \dot\psi))", found, "rad/s");
  result(R"(\mat B\T\,\tilde{\vec\omega})", projected, "rad/s", "other numbers, except across the two axes");
}
//! [rates]

//! [lock]
TEST_CASE("lock: How many times less certain the rates are than ω") {
  const auto condition = [](double theta) {
    const Vector3d stretches = Eigen::JacobiSVD<Matrix3d>(rate_matrix(Vector3d(0.3, theta, 1.1))).singularValues();
    return stretches[0] / stretches[2];
  };
  //! [lock in brief]
  const double psi = 1.1;
  const Vector3d across(-std::cos(psi), std::sin(psi), 0);  // ω of 1 rad/s
  Eigen::MatrixXd table(5, 3);
  for (int row = 0; const double theta : {90.0, 30.0, 10.0, 2.0, 179.0}) {
    const Vector3d rates = euler_angle_rates({0.3, theta * degree, psi}, across);
    table.row(row++) << theta, condition(theta * degree), rates[0];
  }
  //! [lock in brief]

  for (const double theta : {1e-3, 0.01, 0.1, 0.7, pi / 2, 2.0, 3.0, 3.14}) {
    CAPTURE(theta);
    const Matrix3d B = rate_matrix(Vector3d(0.3, theta, 1.1));
    const double c = std::cos(theta);
    CHECK(agrees(B.determinant(), -std::sin(theta), 1e-14));
    CHECK(agrees(B.transpose() * B, Matrix3d{{1, 0, c}, {0, 1, 0}, {c, 0, 1}}, 1e-15));
    CHECK(agrees(condition(theta), std::sqrt((1 + std::abs(c)) / (1 - std::abs(c))), 1e-9));
    CHECK(agrees(condition(theta), theta < 1.6 ? 1 / std::tan(theta / 2) : std::tan(theta / 2), 1e-9));
    CHECK(agrees(euler_angle_rates({0.3, theta, psi}, across)[0], 1 / std::sin(theta), 1e-14));
  }
  CHECK(agrees(condition(0.1), 19.98333055489, 1e-11));
  // The passages of the figure: the axis at a distance from the vertical, crossing it at right angles.
  for (const double theta : {2.0, 10.0, 30.0}) {
    const Vector3d omega(-std::cos(theta * degree), 0, std::sin(theta * degree));
    const Vector3d angles(0, theta * degree, 0);
    CHECK(agrees(euler_angle_rates(angles, rotation_matrix(angles) * omega)[0], 1 / std::sin(theta * degree), 1e-13));
  }

  result_table({R"(\(\theta\) / °)", R"(\(\mathrm{cond}\,\mat B\))", R"(\(\dot\phi\) / (rad/s))"}, table, 4);
}
//! [lock]

//! [names]
TEST_CASE("names: Every attitude has two sets of angles, and upright infinitely many") {
  //! [names in brief]
  const Matrix3d R = rotation_matrix({0.3, 4.5, 1.1});  // θ beyond half a turn
  const Vector3d angles = euler_angles(R);
  const double error = (rotation_matrix(angles) - R).cwiseAbs().maxCoeff();

  const Vector3d upright = euler_angles(rotation_matrix({0.4, 0, 0.9}));
  //! [names in brief]

  CHECK(agrees(angles[1], 2 * pi - 4.5, 1e-14));
  CHECK(error <= 4e-15);
  CHECK(agrees(rotation_matrix({0.3 + pi, -0.7, 1.1 + pi}), rotation_matrix({0.3, 0.7, 1.1}), 1e-15));
  CHECK(agrees(upright[0] + upright[2], 1.3, 1e-15));
  // Beyond a right angle nothing changes.
  for (const Vector3d& asked : {Vector3d(0.3, 2.4, 1.1), Vector3d(2.0, 0.7, 1.1), Vector3d(-2.0, 0.7, -3.0)})
    CHECK(agrees(euler_angles(rotation_matrix(asked)), asked, 1e-14));

  result(R"((\phi,\ \theta,\ \psi))", angles, "rad", "other angles");
  result(R"(\max|\Delta\mat R|)", error, "", "but the same attitude", 1);
  result(R"(\phi + \psi)", upright[0] + upright[2], "rad", R"(at \(\theta = 0\), where only the sum counts)");
}
//! [names]

//! [digits]
TEST_CASE("digits: Near θ = 0 the obvious formulas lose digits, and then everything") {
  //! [digits in brief]
  const Matrix3d R = rotation_matrix({0.4, 1e-8, 0.9});  // nearly upright
  const double by_arccosine = std::acos(R(2, 2));
  const double by_arctangent = std::atan2(std::hypot(R(2, 0), R(2, 1)), R(2, 2));

  Matrix3d upright = rotation_matrix({1.3, 0, 0});
  upright(2, 0) = upright(0, 2) = 3e-17;  // rounding errors of an earlier calculation
  upright(1, 2) = 1e-17;
  const double phi = std::atan2(upright(2, 1), upright(2, 0));
  const double psi = std::atan2(upright(1, 2), -upright(0, 2));
  const Vector3d by_nodes = euler_angles(upright);
  //! [digits in brief]

  CHECK(by_arccosine == 0);
  CHECK(agrees(by_arctangent, 1e-8, 1e-15));
  CHECK(agrees(euler_angles(R)[1], 1e-8, 1e-15));
  CHECK((rotation_matrix({phi, 0, psi}) - upright).cwiseAbs().maxCoeff() > 0.5);
  CHECK((rotation_matrix(by_nodes) - upright).cwiseAbs().maxCoeff() <= 1e-15);
  // Perturbed by 10⁻¹² in every entry, φ is wrong by up to 10⁻¹²/θ, the attitude by 10⁻¹² at every θ.
  const Matrix3d noise = 1e-12 * Matrix3d{{1, -0.7, 0.3}, {-0.6, 0.9, 0.8}, {-0.5, 1, -0.9}};
  for (const double theta : {1.0, 1e-3, 1e-6, 1e-9}) {
    CAPTURE(theta);
    const Matrix3d exact = rotation_matrix({0.4, theta, 0.9});
    const Vector3d found = euler_angles(exact + noise);
    CHECK((rotation_matrix(found) - exact).cwiseAbs().maxCoeff() < 4e-12);
    CHECK(std::abs(found[0] - 0.4) < 2e-12 / theta);
    CHECK(std::abs(found[0] - 0.4) > 0.1e-12 / theta);
  }

  result(R"((\theta_{\arccos},\ \theta_{\mathrm{atan2}}))", Vector2d(by_arccosine, by_arctangent), "rad",
         R"(where \(10^{-8}\) rad is right)");
  result(R"((\phi + \psi)_{\text{separate}})", phi + psi, "rad", "from row and column, where 1.3 rad is right", 4);
  result(R"((\phi + \psi)_{\text{nodes}})", by_nodes[0] + by_nodes[2], "rad", "through the line of nodes", 4);
}
//! [digits]

//! [orbit]
TEST_CASE("orbit: The angles of an orbit are z–x–z") {
  //! [orbit in brief]
  const double node = 40 * degree, inclination = 51.6 * degree, perigee = 30 * degree;
  const Vector3d angles(node - pi / 2, inclination, perigee + pi / 2);  // z–y–z
  const Vector3d to_perigee = inertial_components({1, 0, 0}, angles);
  const Vector3d wrong = inertial_components({1, 0, 0}, {node, inclination, perigee});
  //! [orbit in brief]

  // By the textbooks of astronomy: in the plane of the orbit, cos ω towards the node and sin ω across it.
  const Vector3d to_node(std::cos(node), std::sin(node), 0);
  const Vector3d across(-std::sin(node) * std::cos(inclination), std::cos(node) * std::cos(inclination),
                        std::sin(inclination));
  CHECK(agrees(to_perigee, std::cos(perigee) * to_node + std::sin(perigee) * across, 1e-14));
  for (const Vector3d& any : {Vector3d(0.3, 0.7, 1.1), Vector3d(2.5, 1.2, -2.0)})
    CHECK(agrees(rotation_matrix(any), zxz(any + Vector3d(pi / 2, 0, -pi / 2)), 1e-14));
  const double off = std::acos(to_perigee.dot(wrong));
  CHECK(off > 0.5);
  // With equal angles and rates in both conventions ω(z–x–z) = (ω₂, −ω₁, ω₃).
  const Vector3d at(0.3, 0.7, 1.1), rates(0.5, -0.2, 0.9), omega = angular_velocity_body(at, rates);
  CHECK(agrees(omega_by_differences(zxz, at, rates), Vector3d(omega[1], -omega[0], omega[2]), 1e-9));

  result(R"(\unit e_1)", to_perigee, "", "the direction to the perigee", 4);
  result(R"(\angle)", off / degree, "°", "by which the direction is wrong without converting", 3);
}
//! [orbit]

// Not on the page: with the vertical along L the rates of a free symmetric top are L/I₁, 0 and −Ω.
TEST_CASE("top: The free symmetric top in Euler angles") {
  const Vector3d I(1, 1, 1.8), omega(0.4 * std::cos(0.3), 0.4 * std::sin(0.3), 2);
  const Vector3d L = I.cwiseProduct(omega);
  const double theta = std::acos(L[2] / L.norm()), psi = std::atan2(L[1], -L[0]);
  CHECK(agrees(vertical_in_body(theta, psi), L.normalized(), 1e-14));
  const Vector3d rates = euler_angle_rates(Vector3d(0, theta, psi), omega);
  CHECK(agrees(rates, Vector3d(L.norm() / I[0], 0, -omega[2] * (I[2] - I[0]) / I[0]), 1e-13, 4));
  // All three rates are constant, so the motion is known for all times. Its L must be constant in space.
  for (const double t : {0.0, 0.7, 5.0, -3.0}) {
    CAPTURE(t);
    const Vector3d at = Vector3d(0, theta, psi) + t * rates;
    CHECK(agrees(inertial_components(I.cwiseProduct(angular_velocity_body(at, rates)), at), Vector3d(0, 0, L.norm()),
                 1e-13));
  }
}

// Not on the page: zero, tiny angles, half a turn and beyond, where formulas for rotations go wrong, if they do.
TEST_CASE("laws: The laws of rotations hold at every angle") {
  const Vector3d rates(0.5, -0.2, 0.9);
  const std::vector<Vector3d> hard_angles{{0, 0, 0},
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
  for (const Vector3d& hard : hard_angles) {
    CAPTURE(hard.transpose());
    const Matrix3d R = rotation_matrix(hard);
    CHECK(agrees(R * R.transpose(), Matrix3d::Identity(), 1e-15, 4));
    CHECK(agrees(R.determinant(), 1, 4e-15));
    CHECK(agrees(vertical_in_body(hard[1], hard[2]), R.col(2), 1e-15, 1));
    CHECK(agrees(inertial_components(Vector3d(1, 2, 3), hard), R.transpose() * Vector3d(1, 2, 3), 1e-15, 8));
    CHECK(agrees(inertial_components(line_of_nodes(hard[2]), hard), Vector3d(-std::sin(hard[0]), std::cos(hard[0]), 0),
                 1e-15, 4));
    const Vector3d found = euler_angles(R);
    CHECK(found[1] >= 0);
    CHECK(found[1] <= pi);
    CHECK(agrees(rotation_matrix(found), R, 4e-15));  // the matrices, not the angles

    // ω exists at every attitude; only the way back fails at sin θ = 0.
    const Vector3d omega = angular_velocity_body(hard, rates);
    CHECK(agrees(omega, omega_by_differences(rotation_matrix, hard, rates), 1e-9));
    CHECK(agrees(angular_velocity_inertial(hard, rates), R.transpose() * omega, 1e-15, 4));
    if (std::abs(std::sin(hard[1])) > 1e-3) CHECK(agrees(euler_angle_rates(hard, omega), rates, 1e-12));
  }
}
