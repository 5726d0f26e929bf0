// Worked examples of lecture 03. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/result.hpp"

#include <rigid/inertia_tensor.hpp>

#include <cmath>
#include <numbers>

using namespace rigid;
using workbook::agrees;
using workbook::result;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Four masses, one on each axis and one off all of them: the body of this lecture.
struct FourMasses {
  VectorXd m{{1, 2, 3, 4}};  // kg
  Matrix3Xd r{{1, 0, 0, 1},  // m
              {0, 2, 0, 1},
              {0, 0, 3, 1}};
};

double angle_between(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace

//! [energy]
TEST_CASE("energy: The tensor gives the energy that the points have") {
  const FourMasses body;
  const Vector3d omega(0.3, -0.2, 0.5);  // rad/s

  //! [energy in brief]
  double T_of_points = 0;
  for (int p = 0; p < 4; ++p) {
    const Vector3d v = omega.cross(Vector3d(body.r.col(p)));
    T_of_points += 0.5 * body.m[p] * v.squaredNorm();
  }
  const Matrix3d I = inertia_of_points(body.m, body.r);
  const double T = kinetic_energy(I, omega);
  //! [energy in brief]

  CHECK(agrees(T, T_of_points, 1e-14));
  CHECK(agrees(T, 4.82, 1e-14));
  result("T", T, "J", R"(and the sum over the points gives the same to the last digit)");
}
//! [energy]

//! [matrix]
TEST_CASE("matrix: Only the mass off all axes makes products of inertia") {
  //! [matrix in brief]
  const VectorXd m{{1, 2, 3, 4}};   // kg
  const Matrix3Xd r{{1, 0, 0, 1},   // x of each mass, m
                    {0, 2, 0, 1},   // y
                    {0, 0, 3, 1}};  // z
  const Matrix3d I = inertia_of_points(m, r);
  //! [matrix in brief]

  // I_xx collects m (y² + z²): 2·4 from the second mass, 3·9 from the third, 4·2 from the fourth.
  CHECK(agrees(I(0, 0), 2 * 4 + 3 * 9 + 4 * 2));
  // A mass on a coordinate axis has two vanishing coordinates, so xy, xz and yz are zero for it. What is left comes
  // from the fourth: I_xy = −4·1·1.
  CHECK(agrees(I, Matrix3d{{43, -4, -4}, {-4, 36, -4}, {-4, -4, 17}}));
  result(R"(\Inertia)", I, "kg m²");
}
//! [matrix]

//! [mirror]
TEST_CASE("mirror: Equal masses mirrored in x = 0 cancel in two of the three products") {
  //! [mirror in brief]
  const Matrix3Xd r{{1, -1}, {1, 1}, {1, 1}};  // mirror images in the plane x = 0
  const Matrix3d I = inertia_of_points(VectorXd::Ones(2), r);
  //! [mirror in brief]

  CHECK(agrees(I, Matrix3d{{4, 0, 0}, {0, 4, -2}, {0, -2, 4}}));
  result(R"((I_{xy},\ I_{xz},\ I_{yz}))", Vector3d(I(0, 1), I(0, 2), I(1, 2)), "kg m²");
}
//! [mirror]

//! [momentum]
TEST_CASE("momentum: L = Iω does not point along ω") {
  const FourMasses body;
  const Matrix3d I = inertia_of_points(body.m, body.r);
  //! [momentum in brief]
  const Vector3d omega(0.3, -0.2, 0.5);  // rad/s
  const Vector3d L = angular_momentum(I, omega);
  const double angle = angle_between(L, omega);

  const Vector3d moments = principal_moments(I);
  const double largest = largest_angle_between_L_and_omega(moments);
  //! [momentum in brief]

  Vector3d by_points = Vector3d::Zero();
  for (int p = 0; p < 4; ++p) {
    const Vector3d r = body.r.col(p);
    by_points += body.m[p] * r.cross(omega.cross(r));
  }
  CHECK(agrees(L, by_points, 1e-14));
  CHECK(agrees(L, Vector3d(11.7, -10.4, 8.1), 1e-14));
  // No other direction does better than the bound, and one in the plane of the extreme axes reaches it.
  double found = 0;
  for (int i = 0; i < 360; ++i) {
    for (int j = 0; j < 720; ++j) {
      const double polar = 0.5 * i * degree, azimuth = 0.5 * j * degree;
      const Vector3d n(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
      found = std::max(found, angle_between(I * n, n));
    }
  }
  CHECK(found <= largest);
  CHECK(found > 0.9999 * largest);
  const Matrix3d axes = principal_axes(I);
  const double alpha = std::atan(std::sqrt(moments[0] / moments[2]));
  const Vector3d worst = std::cos(alpha) * axes.col(0) + std::sin(alpha) * axes.col(2);
  CHECK(agrees(angle_between(I * worst, worst), largest, 1e-13));

  result(R"(\vec L)", L, "kg m²/s");
  result(R"(\angle(\vec L,\vec\omega))", angle / degree, "°", "", 4);
  result(R"(\angle_{\max})", largest / degree, "°", "the largest that this body allows", 4);
}
//! [momentum]

//! [dumbbell]
TEST_CASE("dumbbell: To rotate a skew dumbbell steadily takes a torque") {
  //! [dumbbell in brief]
  const Vector3d r(0.15, 0, 0.15 * std::sqrt(3.0));  // 0.3 m, 30° from the axis
  const Matrix3Xd ends{{r[0], -r[0]}, {0, 0}, {r[2], -r[2]}};
  const Matrix3d I = inertia_of_points(VectorXd::Constant(2, 0.5), ends);  // 0.5 kg each
  const Vector3d omega(0, 0, 10);                                          // rad/s
  const Vector3d L = angular_momentum(I, omega);
  const Vector3d torque = omega.cross(L);
  //! [dumbbell in brief]

  // L is perpendicular to the rod, and the torque is that of the centripetal forces −m ω² (distance from the axis).
  CHECK(agrees(L.dot(r), 0, 1e-14, L.norm() * r.norm()));
  const Vector3d force = -0.5 * 100 * Vector3d(r[0], 0, 0);
  CHECK(agrees(torque, 2 * r.cross(force), 1e-14));

  result(R"(\vec L)", L, "kg m²/s", R"(at \(60^\circ\) to the axis)");
  result(R"(\vec\tau)", torque, "N m", R"(perpendicular to the plane of rod and axis, and rotating with it)");
}
//! [dumbbell]

//! [axis]
TEST_CASE("axis: About one axis the nine numbers become one") {
  const FourMasses body;
  const Matrix3d I = inertia_of_points(body.m, body.r);
  //! [axis in brief]
  const Vector3d axis(1, 2, 2);  // of any length
  const double I_n = moment_about_axis(I, axis);

  double by_distances = 0;
  for (int p = 0; p < 4; ++p) {
    const Vector3d r = body.r.col(p);
    by_distances += body.m[p] * r.cross(axis.normalized()).squaredNorm();
  }
  //! [axis in brief]

  CHECK(agrees(I_n, by_distances, 1e-14));
  CHECK(agrees(I_n, 191.0 / 9, 1e-14));
  CHECK(agrees(moment_about_axis(I, 10 * axis), I_n, 1e-14));
  result("I_n", I_n, "kg m²", "and mass times squared distance from the axis gives the same");
}
//! [axis]

//! [cuboid]
TEST_CASE("cuboid: A book about its corner, by the formula and by cutting it into pieces") {
  //! [cuboid in brief]
  const double M = 0.9;                       // kg: a book
  const double a = 0.24, b = 0.17, c = 0.03;  // m
  const Matrix3d I = cuboid_about_corner(M, a, b, c);
  //! [cuboid in brief]

  // Eight point masses at the Gauss points, two to an edge: exact for a uniform body, because the integrand is
  // quadratic.
  Matrix3Xd r(3, 8);
  for (int p = 0; p < 8; ++p) {
    const auto node = [p](int bit) { return 0.5 + ((p >> bit & 1) ? 0.5 : -0.5) / std::sqrt(3.0); };
    r.col(p) << a * node(0), b * node(1), c * node(2);
  }
  CHECK(agrees(I, inertia_of_points(VectorXd::Constant(8, M / 8), r), 1e-14));
  result(R"(\Inertia)", 1e3 * I, "10⁻³ kg m²");
}
//! [cuboid]

//! [cube]
TEST_CASE("cube: One axis of a cube about its corner is fixed, the two others can be chosen") {
  //! [cube in brief]
  const Matrix3d I = cuboid_about_corner(1, 1, 1, 1);  // M = 1 kg, a = 1 m
  const Vector3d moments = principal_moments(I);
  const Matrix3d V = principal_axes(I);
  //! [cube in brief]

  CHECK(agrees(moments, Vector3d(1.0 / 6, 11.0 / 12, 11.0 / 12), 1e-13));
  // The axis of the smallest moment is the body diagonal, and any direction across it is an axis of the other two.
  CHECK(agrees(std::abs(V.col(0).dot(Vector3d::Ones().normalized())), 1, 1e-14));
  for (const Vector3d& across : {Vector3d(1, -1, 0), Vector3d(1, 1, -2), Vector3d(5, -2, -3)})
    CHECK(agrees(I * across, 11.0 / 12 * across, 1e-14));
  // What holds whatever a solver chooses:
  CHECK(agrees(I * V, V * moments.asDiagonal(), 1e-14));
  CHECK(agrees(V.transpose() * V, Matrix3d::Identity(), 1e-14));
  CHECK(agrees(V.determinant(), 1, 1e-14));

  result("(I_1, I_2, I_3)", moments, "kg m²",
         R"(which are \(\tfrac16\), \(\tfrac{11}{12}\), \(\tfrac{11}{12}\) of \(Ma^2\))");
  result(R"(|\unit e_1\cdot(1,1,1)|/\sqrt3)", std::abs(V.col(0).sum()) / std::sqrt(3.0), "");
}
//! [cube]

//! [principal]
TEST_CASE("principal: On principal axes energy and angular momentum lose their cross terms") {
  const Matrix3d I = cuboid_about_corner(0.9, 0.24, 0.17, 0.03);
  const Vector3d omega(3, -2, 5);  // rad/s

  //! [principal in brief]
  const Matrix3d V = principal_axes(I);
  const Vector3d moments = principal_moments(I);

  const Vector3d omega_body = V.transpose() * omega;  // on the principal axes
  const double T = 0.5 * moments.dot(omega_body.cwiseAbs2());
  const Vector3d L_body = moments.cwiseProduct(omega_body);
  //! [principal in brief]

  CHECK(agrees(T, kinetic_energy(I, omega), 1e-13));
  CHECK(agrees(V * L_body, angular_momentum(I, omega), 1e-13));
  result("(I_1, I_2, I_3)", 1e3 * moments, "10⁻³ kg m²", "the moments of the book about its corner");
  result("T", 1e3 * T, "mJ",
         R"(as \(\tfrac12\,\vec\omega\cdot\Inertia\cdot\vec\omega\) gives on the edges of the book)");
}
//! [principal]

//! [rotated]
TEST_CASE("rotated: A phone that has been rotated has products of inertia on the axes of the table") {
  //! [rotated in brief]
  const double M = 0.172, a = 0.1467, b = 0.0715, c = 0.0078;  // kg, m: a phone
  const Vector3d moments = M / 12 * Vector3d(b * b + c * c, a * a + c * c, a * a + b * b);
  const Matrix3d I_body = moments.asDiagonal();
  const double angle = 30 * degree;
  const Matrix3d A = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
  const Matrix3d I = rotated_inertia(I_body, A);
  //! [rotated in brief]

  // To rotate a body does not change what it is: trace, determinant and moments stay.
  CHECK(agrees(I.trace(), I_body.trace(), 1e-14));
  CHECK(agrees(I.determinant(), I_body.determinant(), 1e-13));
  CHECK(agrees(principal_moments(I), Vector3d(I_body.diagonal()), 1e-13));
  // And L = Iω holds on both sets of axes.
  const Vector3d omega(0.3, -0.2, 0.5);
  CHECK(agrees(I * omega, A * (I_body * (A.transpose() * omega)), 1e-13));
  // The product is half the difference of the moments times sin 2·30°.
  CHECK(agrees(I(0, 1), 0.5 * (I_body(0, 0) - I_body(1, 1)) * std::sin(60 * degree), 1e-13));
  // The rate while it rotates about the vertical, [ω]I − I[ω], against a small turn.
  const double dt = 1e-6;
  const Matrix3d step = Eigen::AngleAxisd(dt, Vector3d::UnitZ()).toRotationMatrix();
  const Matrix3d cross{{0, -1, 0}, {1, 0, 0}, {0, 0, 0}};
  CHECK(agrees((rotated_inertia(I, step) - rotated_inertia(I, step.transpose())) / (2 * dt), cross * I - I * cross,
               1e-8));

  result(R"(\mathrm{diag}\,\Inertia_\bodyframe)", 1e6 * I_body.diagonal(), "10⁻⁶ kg m²");
  result(R"(\Inertia_\inertialframe)", 1e6 * I, "10⁻⁶ kg m²");
}
//! [rotated]

//! [station]
TEST_CASE("station: A space station of six modules, whose axes nobody would guess") {
  //! [station in brief]
  const VectorXd m{{3, 4, 7, 5, 4, 3}};      // in tonnes
  const Matrix3Xd r{{6, 3, -4, -4, 3, 2},    // x of each module, m
                    {-2, 1, 1, -2, 2, -1},   // y
                    {0, -2, 2, -4, -1, 6}};  // z
  const Matrix3d I = inertia_of_points(m, r);
  Vector3d axis = principal_axes(I).col(2);
  //! [station in brief]

  CHECK(agrees(r * m / m.sum(), Vector3d::Zero(), 1e-14, 1));  // the origin is the centre of mass
  CHECK(agrees(I, Matrix3d{{298, -6, -24}, {-6, 620, -20}, {-24, -20, 446}}, 1e-13));

  axis *= axis[1] > 0 ? 1 : -1;  // an axis has no sign of its own: its largest component shall be positive
  CHECK(agrees(I * axis, principal_moments(I)[2] * axis, 1e-13));
  result("(I_1, I_2, I_3)", principal_moments(I), "t m²", "", 4);
  result(R"(\unit e_3)", axis, "", R"(close to the y axis, whose moment is the largest on the diagonal)", 4);
}
//! [station]

//! [validity]
TEST_CASE("validity: Which symmetric matrices are inertia tensors") {
  //! [validity in brief]
  const Matrix3d I{{2, -0.8, 0}, {-0.8, 2, -0.8}, {0, -0.8, 2}};
  const Vector3d moments = principal_moments(I);  // ascending
  const int some_body_has_it = is_inertia_tensor(I);
  //! [validity in brief]

  const auto second_moments = [](const Matrix3d& tensor) -> Matrix3d {
    return 0.5 * tensor.trace() * Matrix3d::Identity() - tensor;  // Σ m r r
  };
  const Vector3d c = principal_moments(second_moments(I));
  CHECK(c[0] < 0);
  CHECK(some_body_has_it == 0);
  // Two more that look harmless; and one of a real body.
  CHECK(principal_moments(second_moments(Matrix3d{{4, 2.1, 0}, {2.1, 4, 0}, {0, 0, 4}}))[0] < 0);
  CHECK(principal_moments(second_moments(Vector3d(10, 10, 30).asDiagonal()))[0] < 0);
  const FourMasses body;
  const Matrix3d real = inertia_of_points(body.m, body.r);
  const Matrix3d C = second_moments(real);
  Matrix3d expected = Matrix3d::Zero();
  for (int p = 0; p < 4; ++p) expected += body.m[p] * body.r.col(p) * body.r.col(p).transpose();
  CHECK(agrees(C, expected, 1e-14));
  // Six masses of ½ kg at ±√c ê have the same tensor.
  const Vector3d roots = principal_moments(C).cwiseSqrt();
  const Matrix3d axes = principal_axes(C);
  Matrix3Xd six(3, 6);
  six << axes * roots.asDiagonal(), -axes * roots.asDiagonal();
  CHECK(agrees(inertia_of_points(VectorXd::Constant(6, 0.5), six), real, 1e-13));

  result("(I_1, I_2, I_3)", moments, "kg m²", "all positive");
  result("c_1", c[0], "kg m²", R"(negative, because \(I_3 > I_1 + I_2\): no body has this tensor)");
}
//! [validity]
