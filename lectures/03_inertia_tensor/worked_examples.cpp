// Worked examples of lecture 03. Each case is a paragraph of the notes that computes its own numbers.
#include "lectures/support/agrees.hpp"
#include "lectures/support/printed.hpp"

#include <rigid/inertia_tensor.hpp>

#include <cmath>
#include <numbers>

using namespace rigid;
using workbook::agrees;
using workbook::Printed;
using workbook::row;

namespace {

/// Four masses, one on each axis and one off all of them: the body of this lecture.
struct FourMasses {
  VectorXd m{{1, 2, 3, 4}};
  Matrix3Xd r{{1, 0, 0, 1},   // x
              {0, 2, 0, 1},   // y
              {0, 0, 3, 1}};  // z
};

}  // namespace

//! [four masses]
TEST_CASE("Four masses: only the one off the axes makes products of inertia") {
  const FourMasses body;

  const Matrix3d I = inertia_of_points(body.m, body.r);

  // I_xx collects m (y² + z²): 2·4 from the second mass, 3·9 from the third, 4·2 from the fourth.
  CHECK(agrees(I(0, 0), 2 * 4 + 3 * 9 + 4 * 2));
  // A mass on a coordinate axis has two vanishing coordinates, so xy, xz and yz are zero for it. What is left comes
  // from the fourth: I_xy = −4·1·1.
  CHECK(agrees(I, Matrix3d{{43, -4, -4}, {-4, 36, -4}, {-4, -4, 17}}));

  Printed page("four masses");
  page.line("I (kg m²) =");
  page.matrix(I);
}
//! [four masses]

//! [energy two ways]
TEST_CASE("The tensor knows the energy that the points have") {
  const FourMasses body;
  const Vector3d omega(0.3, -0.2, 0.5);

  // Point by point: every mass moves with velocity ω × r.
  double by_points = 0;
  for (int p = 0; p < 4; ++p) by_points += 0.5 * body.m[p] * omega.cross(Vector3d(body.r.col(p))).squaredNorm();

  // With the tensor: the positions are needed once, and every ω after that costs a matrix product.
  const double by_tensor = kinetic_energy(inertia_of_points(body.m, body.r), omega);

  CHECK(agrees(by_tensor, by_points, 1e-14));
  CHECK(agrees(by_tensor, 4.82, 1e-14));

  Printed page("energy two ways");
  page.line("T point by point = {:.12g} J", by_points);
  page.line("T = ½ ω·I·ω      = {:.12g} J", by_tensor);
}
//! [energy two ways]

//! [momentum is not parallel]
TEST_CASE("L = Iω, and it does not point along ω") {
  const FourMasses body;
  const Vector3d omega(0.3, -0.2, 0.5);
  Vector3d by_points = Vector3d::Zero();
  for (int p = 0; p < 4; ++p) {
    const Vector3d r = body.r.col(p);
    by_points += body.m[p] * r.cross(omega.cross(r));
  }

  const Vector3d L = angular_momentum(inertia_of_points(body.m, body.r), omega);

  CHECK(agrees(L, by_points, 1e-14));
  CHECK(agrees(L, Vector3d(11.7, -10.4, 8.1), 1e-14));
  // L·ω = 2T > 0, so the angle between them is always acute; here it is large all the same.
  const double angle = std::acos(L.normalized().dot(omega.normalized())) * 180 / std::numbers::pi;
  CHECK(angle > 25);
  CHECK(angle < 90);

  Printed page("momentum is not parallel");
  page.line("ω = {} rad/s", row(omega));
  page.line("L = {} kg m²/s", row(L));
  page.line("angle between them: {:.2f}°", angle);
}
//! [momentum is not parallel]

//! [axis]
TEST_CASE("About an axis the nine numbers become one") {
  const FourMasses body;
  const Matrix3d I = inertia_of_points(body.m, body.r);
  const Vector3d axis(1, 2, 2);

  // Distance from the axis, mass by mass: |r|² less the square of the part along the axis.
  double by_distances = 0;
  for (int p = 0; p < 4; ++p) {
    const Vector3d r = body.r.col(p);
    by_distances += body.m[p] * (r.squaredNorm() - std::pow(r.dot(axis) / axis.norm(), 2));
  }

  CHECK(agrees(moment_about_axis(I, axis), by_distances, 1e-14));
  CHECK(agrees(moment_about_axis(I, axis), 191.0 / 9, 1e-14));
  CHECK(agrees(moment_about_axis(I, 10 * axis), moment_about_axis(I, axis),
               1e-14));  // the length of the arrow is no matter

  Printed page("axis");
  page.line("I about (1, 2, 2): {:.10g} kg m²", moment_about_axis(I, axis));
}
//! [axis]

//! [cuboid about its corner]
TEST_CASE("A cuboid about its corner, by the formula and by cutting it into pieces") {
  const double M = 6, a = 1, b = 2, c = 3;

  // Two Gauss points per edge stand exactly for a uniform mass as long as the integrand is quadratic, and it is.
  Matrix3Xd r(3, 8);
  for (int p = 0; p < 8; ++p) {
    const auto node = [p](int bit) { return 0.5 + ((p >> bit & 1) ? 0.5 : -0.5) / std::sqrt(3.0); };
    r.col(p) << a * node(0), b * node(1), c * node(2);
  }
  const Matrix3d by_pieces = inertia_of_points(VectorXd::Constant(8, M / 8), r);

  const Matrix3d I = cuboid_about_corner(M, a, b, c);

  CHECK(agrees(I, by_pieces, 1e-14));
  CHECK(agrees(I, Matrix3d{{26, -3, -4.5}, {-3, 20, -9}, {-4.5, -9, 10}}, 1e-14));

  Printed page("cuboid about its corner");
  page.line("I (kg m²) =");
  page.matrix(I);
}
//! [cuboid about its corner]

//! [cube]
TEST_CASE("V01 The cube of the slides: 1/6, 11/12, 11/12") {
  const Matrix3d I = cuboid_about_corner(1, 1, 1, 1);

  const Vector3d moments = principal_moments(I);
  CHECK(agrees(moments, Vector3d(1.0 / 6, 11.0 / 12, 11.0 / 12), 1e-13));  // slides; Taylor, Example 10.2

  // The axis of the smallest moment is the body diagonal. The other two moments are equal, so any two orthogonal
  // directions perpendicular to the diagonal will do: a solver chooses a pair, nature does not.
  const Matrix3d axes = principal_axes(I);
  const Vector3d diagonal = Vector3d::Ones().normalized();
  CHECK(agrees(std::abs(axes.col(0).dot(diagonal)), 1, 1e-14));
  const Vector3d somewhere_across(1, -1, 0);
  CHECK(agrees(I * somewhere_across, 11.0 / 12 * somewhere_across, 1e-14));

  // What does hold for every solver's choice:
  CHECK(agrees(I * axes, axes * moments.asDiagonal(), 1e-14));
  CHECK(agrees(axes.transpose() * axes, Matrix3d::Identity(), 1e-14));
  CHECK(agrees(axes.determinant(), 1, 1e-14));

  Printed page("cube");
  page.line("moments / Ma²   = {}", row(moments));
  page.line("1/6, 11/12      = {:.10g}, {:.10g}", 1.0 / 6, 11.0 / 12);
  Printed("V01").line("V01 | 1/6, 11/12, 11/12 | {} | 1e-13", row(moments, "{:.14f}"));
}
//! [cube]

//! [principal coordinates]
TEST_CASE("On principal axes energy and momentum lose their cross terms") {
  const Matrix3d I = cuboid_about_corner(6, 1, 2, 3);
  const Vector3d omega(0.3, -0.2, 0.5);
  const Matrix3d axes = principal_axes(I);
  const Vector3d moments = principal_moments(I);

  const Vector3d omega_body = axes.transpose() * omega;  // the components that the slides mark with a tilde

  CHECK(agrees(kinetic_energy(I, omega), 0.5 * moments.dot(omega_body.cwiseAbs2()), 1e-14));
  CHECK(agrees(angular_momentum(I, omega), axes * moments.cwiseProduct(omega_body), 1e-14));

  Printed page("principal coordinates");
  page.line("principal moments = {} kg m²", row(moments));
  page.line("T = {:.12g} J on either set of axes", kinetic_energy(I, omega));
}
//! [principal coordinates]

//! [turned body]
TEST_CASE("The tensor of a turned body has products of inertia that its own axes do not show") {
  const Matrix3d I_body = Vector3d(1, 2, 3).asDiagonal();
  const Matrix3d A = (Eigen::AngleAxisd(0.3, Vector3d::UnitZ()) * Eigen::AngleAxisd(0.7, Vector3d::UnitY()) *
                      Eigen::AngleAxisd(1.1, Vector3d::UnitZ()))
                         .toRotationMatrix();

  const Matrix3d I = rotated_inertia(I_body, A);

  // Turning a body does not change what it is: trace, determinant and moments stay.
  CHECK(agrees(I.trace(), 6, 1e-14));
  CHECK(agrees(I.determinant(), 6, 1e-14));
  CHECK(agrees(principal_moments(I), Vector3d(1, 2, 3), 1e-14));
  // And L = Iω holds on both sets of axes.
  const Vector3d omega(0.3, -0.2, 0.5);
  CHECK(agrees(I * omega, A * (I_body * (A.transpose() * omega)), 1e-14));

  Printed page("turned body");
  page.line("I on inertial axes (kg m²) =");
  page.matrix(I, "{:12.8f}");
}
//! [turned body]

//! [space station]
TEST_CASE("V11 A space station of six modules: real data, awkward axes") {
  // Six modules as points, from the space-dynamics workbook's example 10 (masses in units of a module's mass).
  const VectorXd m{{3, 4, 7, 5, 4, 3}};
  const Matrix3Xd r{{6, 3, -4, -4, 3, 2}, {-2, 1, 1, -2, 2, -1}, {0, -2, 2, -4, -1, 6}};
  CHECK(agrees(r * m / m.sum(), Vector3d::Zero(), 1e-14, 1));  // the origin is the centre of mass

  const Matrix3d I = inertia_of_points(m, r);

  CHECK(agrees(I, Matrix3d{{298, -6, -24}, {-6, 620, -20}, {-24, -20, 446}}, 1e-13));
  CHECK(agrees(principal_moments(I), Vector3d(293.95245163, 447.74525937, 622.302289), 1e-8));

  Printed page("space station");
  page.line("principal moments = {}", row(principal_moments(I), "{:.6f}"));
  page.line("axis of the largest = {}", row(principal_axes(I).col(2).cwiseAbs(), "{:.4f}"));
  Printed("V11").line("V11 | 293.95245163, 447.74525937, 622.302289 | {} | 1e-8", row(principal_moments(I), "{:.8f}"));
}
//! [space station]

//! [validity]
TEST_CASE("V16 Not every symmetric matrix is an inertia tensor") {
  // Of three moments none may exceed the sum of the other two: I₁ + I₂ − I₃ = 2 Σ m z² ≥ 0.
  const auto belongs_to_a_body = [](const Matrix3d& I) {
    const Vector3d moments = principal_moments(I);
    return moments[0] >= 0 && moments[0] + moments[1] >= moments[2];
  };

  const FourMasses body;
  CHECK(belongs_to_a_body(inertia_of_points(body.m, body.r)));
  CHECK(belongs_to_a_body(cuboid_about_corner(1, 1, 1, 1)));

  // Three that look innocent and belong to no body (Drake, tests of its rotational inertia):
  const Matrix3d first{{2, -0.8, 0}, {-0.8, 2, -0.8}, {0, -0.8, 2}};
  CHECK_FALSE(belongs_to_a_body(first));
  CHECK_FALSE(belongs_to_a_body(Matrix3d{{4, 2.1, 0}, {2.1, 4, 0}, {0, 0, 4}}));
  CHECK_FALSE(belongs_to_a_body(Vector3d(10, 10, 30).asDiagonal()));
  CHECK(agrees(principal_moments(first), Vector3d(0.868629, 2, 3.131371), 1e-6));

  Printed page("validity");
  const Vector3d moments = principal_moments(first);
  page.line("moments {}: {:.4f} + {:.4f} < {:.4f}", row(moments, "{:.4f}"), moments[0], moments[1], moments[2]);
  Printed("V16").line("V16 | 0.868629, 2, 3.131371, invalid | {}, {} | 1e-6", row(moments, "{:.6f}"),
                      belongs_to_a_body(first) ? "valid" : "invalid");
}
//! [validity]
