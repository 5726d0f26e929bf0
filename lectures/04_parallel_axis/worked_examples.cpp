// Worked examples of lecture 04. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/result.hpp"

#include <rigid/inertia_tensor.hpp>
#include <rigid/parallel_axis.hpp>

#include <cmath>
#include <numbers>

using namespace rigid;
using workbook::agrees;
using workbook::result;

namespace {

constexpr double pi = std::numbers::pi;

/// Point masses: masses, and positions as columns.
struct Points {
  VectorXd m;
  Matrix3Xd r;

  double mass() const { return m.sum(); }
  Vector3d center() const { return r * m / m.sum(); }
  Matrix3d inertia() const { return inertia_of_points(m, r); }
  Points moved(const Vector3d& by) const { return {m, r.colwise() + by}; }
};

/// The four masses of lecture 03, which have no symmetry at all.
Points four_masses() { return {VectorXd{{1, 2, 3, 4}}, Matrix3Xd{{1, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 3, 1}}}; }

/// Eight point masses with all second moments of a uniform cuboid: they sit at the Gauss points, two to an edge.
Points cuboid_as_points(double M, double a, double b, double c) {
  Points points{VectorXd::Constant(8, M / 8), Matrix3Xd(3, 8)};
  for (int p = 0; p < 8; ++p) {
    const auto side = [p](int bit) { return p >> bit & 1 ? 0.5 : -0.5; };
    points.r.col(p) = Vector3d(a * side(0), b * side(1), c * side(2)) / std::sqrt(3.0);
  }
  return points;
}

}  // namespace

//! [door]
TEST_CASE("door: About its hinge a door has four times the moment, and a product of inertia") {
  //! [door in brief]
  const double M = 25, a = 0.8, b = 0.04, c = 2.0;  // kg, m: a door, its hinge along z
  const Matrix3d I_cm = cuboid_about_center(M, a, b, c);
  const Vector3d d(-a / 2, -b / 2, 0);  // from the centre to the edge with the hinge
  const Matrix3d I = inertia_from_center_of_mass(I_cm, M, d);
  //! [door in brief]

  const Points door = cuboid_as_points(M, a, b, c);
  CHECK(agrees(I, door.moved(-d).inertia(), 1e-14));
  CHECK(agrees(I(2, 2), 4 * I_cm(2, 2), 1e-14));
  CHECK(agrees(I(0, 1), -M * a * b / 4, 1e-14));

  // The same for a body without symmetry: seen from d, the positions are r − d.
  const Points body = four_masses(), at_center = body.moved(-body.center());
  const Vector3d away(1, -1, 2);
  const Matrix3d there = inertia_from_center_of_mass(at_center.inertia(), body.mass(), away);
  CHECK(agrees(there, at_center.moved(-away).inertia(), 1e-14));
  CHECK(agrees(there, Matrix3d{{69.7, 10, -17.5}, {10, 66.6, 26.4}, {-17.5, 26.4, 28.1}}, 1e-14));
  // What was added is the tensor of a single mass M; and the mirror point has the same tensor.
  CHECK(agrees(there - at_center.inertia(), inertia_of_points(VectorXd{{body.mass()}}, away), 1e-14));
  CHECK(agrees(inertia_from_center_of_mass(at_center.inertia(), body.mass(), -away), there, 1e-15));

  result(R"(I_{zz,\CM})", I_cm(2, 2), "kg m²");
  result("I_{zz}", I(2, 2), "kg m²", "about the hinge");
  result("I_{xy}", I(0, 1), "kg m²", R"(which is \(-M d_x d_y\); about the centre there is no product)");
}
//! [door]

//! [pendulum]
TEST_CASE("pendulum: A ruler hung from a nail has the same period at two distances") {
  const double g = 9.81;  // m/s²
  //! [pendulum in brief]
  const double M = 0.05, l = 1.0;  // kg, m: a ruler along z
  const Matrix3d I_cm = cuboid_about_center(M, 0, 0, l);
  const auto period = [&](double d) {
    const double I = inertia_from_center_of_mass(I_cm, M, Vector3d(0, 0, d))(1, 1);
    return 2 * pi * std::sqrt(I / (M * g * d));
  };
  const double d0 = std::sqrt(I_cm(1, 1) / M);  // radius of gyration
  //! [pendulum in brief]

  CHECK(agrees(d0, l / std::sqrt(12.0), 1e-15));
  for (const double d : {0.05, 0.2, 0.28, 0.3, 0.45}) {
    CHECK(period(d) > period(d0));
    CHECK(agrees(period(d0 * d0 / d), period(d), 1e-14));
    CHECK(agrees(period(d), 2 * pi * std::sqrt((d + d0 * d0 / d) / g), 1e-14));
  }
  // Followed in time: a quarter of a swing of 10⁻⁴ rad, by the midpoint rule, ends where the ruler is upright.
  const double I = inertia_from_center_of_mass(I_cm, M, Vector3d(0, 0, 0.5))(1, 1), h = 1e-5;
  double angle = 1e-4, rate = 0, time = 0;
  for (; angle > 0; time += h) {
    const double middle = angle + h / 2 * rate;
    const double acceleration = -M * g * 0.5 / I * std::sin(middle);
    angle += h * (rate + h / 2 * acceleration);
    rate += h * acceleration;
  }
  CHECK(agrees(4 * time, period(0.5), 1e-4));

  result("d_0", d0, "m");
  result("P(d_0)", period(d0), "s", "the shortest period");
  result(R"(P(0.5\,\mathrm m))", period(0.5), "s", "hung from its end");
  result("d_0^2/d", d0 * d0 / 0.5, "m", R"(for \(d = 0.5\) m: a nail at a third of the length)");
  result(R"(P(d_0^2/d))", period(d0 * d0 / 0.5), "s", "the same");
}
//! [pendulum]

//! [shifted]
TEST_CASE("shifted: From any origin to any other") {
  const Points body = four_masses();
  const Matrix3d I_origin = body.inertia();
  const Vector3d r_cm = body.center();
  const double M = body.mass();

  //! [shifted in brief]
  const Vector3d R(0.5, -1, 2);  // m, added to every position
  const Matrix3d I = inertia_about_shifted_origin(I_origin, M, r_cm, R);
  const Matrix3d mistaken = inertia_from_center_of_mass(I_origin, M, R);
  //! [shifted in brief]

  CHECK(agrees(I, body.moved(R).inertia(), 1e-14));
  CHECK(agrees(I, Matrix3d{{129, 2, -30.5}, {2, 135.5, 13}, {-30.5, 13, 18.5}}, 1e-14));
  // In two steps over the centre of mass, whose position becomes r_CM + R.
  const Matrix3d I_cm = inertia_to_center_of_mass(I_origin, M, r_cm);
  CHECK(agrees(I, inertia_from_center_of_mass(I_cm, M, r_cm + R), 1e-14));
  CHECK_FALSE(agrees(mistaken, I, 0.1));

  result(R"(\Inertia')", I, "kg m²");
  result(R"(\text{without } \vec r_\CM\text{: }\Inertia')", mistaken, "kg m²", "wrong and yet symmetric and positive");
}
//! [shifted]

//! [direction]
TEST_CASE("direction: R points from the new origin to the old one") {
  const Points body = four_masses();
  const Matrix3d I_origin = body.inertia();
  const Vector3d r_cm = body.center();
  const double M = body.mass();

  //! [direction in brief]
  const Vector3d new_origin(-0.5, 1, -2);  // m
  const Matrix3d I = inertia_about_shifted_origin(I_origin, M, r_cm, -new_origin);
  const Matrix3d reversed = inertia_about_shifted_origin(I_origin, M, r_cm, new_origin);
  //! [direction in brief]

  CHECK(agrees(I, body.moved(-new_origin).inertia(), 1e-14));
  CHECK(agrees(reversed, body.moved(new_origin).inertia(), 1e-14));  // a perfectly good tensor of the mirror point
  CHECK_FALSE(agrees(reversed, I, 0.1));
  // With the origin at the centre of mass nothing is left of the difference.
  const Matrix3d I_cm = inertia_to_center_of_mass(I_origin, M, r_cm);
  CHECK(agrees(inertia_about_shifted_origin(I_cm, M, Vector3d::Zero(), new_origin),
               inertia_about_shifted_origin(I_cm, M, Vector3d::Zero(), -new_origin), 1e-14));

  result("(I_1, I_2, I_3)", principal_moments(I), "kg m²");
  result(R"(\vec R\text{ reversed: }(I_1, I_2, I_3))", principal_moments(reversed), "kg m²");
}
//! [direction]

//! [back]
TEST_CASE("back: About the centre of mass every moment is smallest") {
  const Points body = four_masses();
  const Matrix3d I_origin = body.inertia();

  //! [back in brief]
  const double M = body.m.sum();
  const Vector3d r_cm = body.r * body.m / M;
  const Matrix3d I_cm = inertia_to_center_of_mass(I_origin, M, r_cm);
  const Vector3d subtracted = principal_moments(I_origin - I_cm);
  //! [back in brief]

  CHECK(agrees(I_cm, body.moved(-r_cm).inertia(), 1e-14));
  CHECK(agrees(I_cm, Matrix3d{{19.7, 0, 2.5}, {0, 16.6, 6.4}, {2.5, 6.4, 8.1}}, 1e-14));
  CHECK(subtracted.minCoeff() >= -1e-13);
  CHECK(agrees(subtracted, M * r_cm.squaredNorm() * Vector3d(0, 1, 1), 1e-13));

  // On the way, at R = −s r_CM, the change is (s² − 2s) M (r² 1 − r r). The short form has −s²: right at the end only.
  const Matrix3d mass_at_center = inertia_of_points(VectorXd{{M}}, r_cm);
  for (const double s : {0.0, 0.5, 1.0, 2.0, 3.0}) {
    const Matrix3d change = inertia_about_shifted_origin(I_origin, M, r_cm, -s * r_cm) - I_origin;
    CHECK(agrees(change, (s * s - 2 * s) * mass_at_center, 1e-13, M * (1 + s * s)));
  }

  result(R"(\vec r_\CM)", r_cm, "m");
  result(R"(\Inertia_\CM)", I_cm, "kg m²");
  result(R"(\Inertia - \Inertia_\CM)", subtracted, "kg m²",
         R"(on its principal axes: nothing along \(\vec r_\CM\), \(Mr_\CM^2\) across it)");
}
//! [back]

//! [book]
TEST_CASE("book: From the corner of a book to its centre, a third becomes a twelfth") {
  //! [book in brief]
  const double M = 0.9, a = 0.24, b = 0.17, c = 0.03;  // kg, m: the book of lecture 03
  const Matrix3d corner = cuboid_about_corner(M, a, b, c);
  const Vector3d R(-a / 2, -b / 2, -c / 2);
  const Matrix3d center = inertia_about_shifted_origin(corner, M, -R, R);
  //! [book in brief]

  CHECK(agrees(center, cuboid_about_center(M, a, b, c), 1e-14));
  CHECK(agrees(center, cuboid_as_points(M, a, b, c).inertia(), 1e-14));
  CHECK(agrees(center.diagonal(), corner.diagonal() / 4, 1e-14));
  CHECK(agrees(center, corner - inertia_of_points(VectorXd{{M}}, R), 1e-14));
  CHECK(agrees(cuboid_about_center(6, 1, 2, 3), Matrix3d(Vector3d(6.5, 5, 2.5).asDiagonal()), 1e-14));
  // With R reversed the new origin lies as far beyond the corner as the centre lies inside.
  CHECK(agrees(inertia_about_shifted_origin(corner, M, -R, -R), inertia_from_center_of_mass(center, M, 2 * R), 1e-14));

  // 1/12 without an integral: halving a rod gives x = x/4 + 1/16; and two unequal slices make the whole.
  double x = 0;
  for (int halving = 0; halving < 40; ++halving) x = x / 4 + 1.0 / 16;
  CHECK(agrees(cuboid_about_center(1, 1, 0, 0)(1, 1), x, 1e-15));
  const double cut = 0.3 * a;
  const VectorXd m{{0.3 * M, 0.7 * M}};
  CHECK(agrees(combined_inertia(m, Matrix3Xd{{cut / 2, (cut + a) / 2}, {0, 0}, {0, 0}},
                                {cuboid_about_center(m[0], cut, b, c), cuboid_about_center(m[1], a - cut, b, c)}),
               center, 1e-14));

  result(R"(\Inertia)", 1e3 * corner, "10⁻³ kg m²", "about the corner");
  result(R"(\mathrm{diag}\,\Inertia_\CM)", 1e3 * center.diagonal(), "10⁻³ kg m²");
}
//! [book]

//! [wedge]
TEST_CASE("wedge: A door wedge keeps a product of inertia about its centre of mass") {
  //! [wedge in brief]
  const double M = 0.15, a = 0.12, b = 0.04, c = 0.03;  // kg, m: length, height, width
  // The second moments of a triangle: equal masses at the middles of its sides.
  const double x = a / 2, y = b / 2, z = c / std::sqrt(12.0);
  const Matrix3Xd r{{x, x, 0, x, x, 0}, {0, y, y, 0, y, y}, {z, z, z, -z, -z, -z}};
  const Matrix3d I = inertia_of_points(VectorXd::Constant(6, M / 6), r);
  const Matrix3d I_cm = inertia_to_center_of_mass(I, M, r.rowwise().mean());
  const double tilt = 0.5 * std::atan(2 * I_cm(0, 1) / (I_cm(0, 0) - I_cm(1, 1)));
  //! [wedge in brief]

  CHECK(agrees(r.rowwise().mean(), Vector3d(a / 3, b / 3, 0), 1e-14));
  CHECK(agrees(I_cm(0, 1), M * a * b / 36, 1e-13));
  CHECK(
      agrees(Vector2d(I_cm(0, 0), I_cm(1, 1)), M * Vector2d(b * b / 18 + c * c / 12, a * a / 18 + c * c / 12), 1e-13));
  CHECK(agrees(Vector2d(I_cm(0, 2), I_cm(1, 2)), Vector2d::Zero(), 1e-14, I_cm(2, 2)));  // a mirror plane is left
  const Vector3d axis(std::cos(tilt), std::sin(tilt), 0);
  CHECK(agrees(I_cm * axis, principal_moments(I_cm)[0] * axis, 1e-13));
  // Two wedges make a cuboid, and their products cancel.
  const Vector3d center = r.rowwise().mean();
  Matrix3Xd centers(3, 2);
  centers << center, Vector3d(a, b, 0) - center;
  CHECK(agrees(combined_inertia(VectorXd{{M, M}}, centers, {I_cm, I_cm}), cuboid_about_center(2 * M, a, b, c), 1e-14));

  result(R"(\mathrm{diag}\,\Inertia_\CM)", 1e6 * I_cm.diagonal(), "10⁻⁶ kg m²");
  result("I_{xy}", 1e6 * I_cm(0, 1), "10⁻⁶ kg m²", R"(which is \(\tfrac1{36}Mab\))");
  result(R"(\alpha)", tilt * 180 / pi, "°", "from the x axis to the axis of the smallest moment", 4);
}
//! [wedge]

//! [handle]
TEST_CASE("handle: A T-handle, put together from its grip and its stem") {
  //! [handle in brief]
  const VectorXd m{{0.113, 0.057}};                      // kg: grip and stem, of steel
  const Matrix3Xd centers{{0, 0}, {0, -0.031}, {0, 0}};  // m: the stem along −y
  const Matrix3d grip = cuboid_about_center(m[0], 0.1, 0.012, 0.012);
  const Matrix3d stem = cuboid_about_center(m[1], 0.012, 0.05, 0.012);
  const Matrix3d I = combined_inertia(m, centers, {grip, stem});
  //! [handle in brief]

  const double reduced = m[0] * m[1] / m.sum();
  CHECK(agrees(I, grip + stem + inertia_of_points(VectorXd{{reduced}}, centers.col(1) - centers.col(0)), 1e-14));
  // About the origin first, then back to the common centre.
  const Matrix3d about_origin = grip + inertia_from_center_of_mass(stem, m[1], centers.col(1));
  CHECK(agrees(I, inertia_to_center_of_mass(about_origin, m.sum(), centers * m / m.sum()), 1e-14));
  CHECK(I(0, 0) < I(1, 1));
  CHECK(I(1, 1) < I(2, 2));  // the axis along the stem is the intermediate one

  const Matrix3d two =
      combined_inertia(VectorXd{{2, 3}}, Matrix3Xd{{0, 1}, {0, 2}, {0, 3}},
                       {Matrix3d(Vector3d(1, 2, 2.5).asDiagonal()), Matrix3d(Vector3d(0.5, 0.6, 0.7).asDiagonal())});
  CHECK(agrees(two, Matrix3d{{17.1, -2.4, -3.6}, {-2.4, 14.6, -7.2}, {-3.6, -7.2, 9.2}}, 1e-14));

  result(R"(\vec r_\CM)", 1e3 * centers * m / m.sum(), "mm", "from the middle of the grip", 3);
  result(R"(\mathrm{diag}\,\Inertia)", 1e6 * I.diagonal(), "10⁻⁶ kg m²", "about the common centre of mass", 4);
}
//! [handle]

//! [wheel]
TEST_CASE("wheel: A rolling wheel carries half of its angular momentum in its spin") {
  //! [wheel in brief]
  const double M = 1.2, radius = 0.34, v = 5;  // kg, m, m/s: the rim of a bicycle wheel
  const Vector3d r_cm(0, 0, radius), v_cm(v, 0, 0), omega(0, v / radius, 0);
  const Matrix3d I_cm = M * radius * radius * Vector3d(0.5, 1, 0.5).asDiagonal();
  const Vector3d L = r_cm.cross(M * v_cm) + angular_momentum(I_cm, omega);
  const double T = 0.5 * M * v_cm.squaredNorm() + kinetic_energy(I_cm, omega);
  //! [wheel in brief]

  // The point that touches the ground is at rest for the moment: about it the body only rotates.
  const Matrix3d I_contact = inertia_from_center_of_mass(I_cm, M, -r_cm);
  CHECK(agrees(L, angular_momentum(I_contact, omega), 1e-14));
  CHECK(agrees(T, kinetic_energy(I_contact, omega), 1e-14));

  // Point by point, for a body without symmetry whose origin moves: König's two sums, and the mixed term.
  const Points body = four_masses();
  const Vector3d spin(0.3, -0.2, 0.5), v_origin(0.4, 1.1, -0.6),
      O(0.7, -0.4, 1.5);  // O: the origin seen from a fixed point
  Vector3d momentum = Vector3d::Zero();
  double energy = 0;
  for (int p = 0; p < body.m.size(); ++p) {
    const Vector3d r = body.r.col(p), velocity = v_origin + spin.cross(r);
    momentum += body.m[p] * (O + r).cross(velocity);
    energy += 0.5 * body.m[p] * velocity.squaredNorm();
  }
  const Vector3d v_center = v_origin + spin.cross(body.center());
  const Matrix3d about_center = inertia_to_center_of_mass(body.inertia(), body.mass(), body.center());
  CHECK(agrees(momentum, (O + body.center()).cross(body.mass() * v_center) + about_center * spin, 1e-14));
  CHECK(agrees(energy, 0.5 * body.mass() * v_center.squaredNorm() + kinetic_energy(about_center, spin), 1e-14));
  CHECK(agrees(energy,
               kinetic_energy(body.inertia(), spin) + 0.5 * body.mass() * v_origin.squaredNorm() +
                   body.mass() * v_origin.dot(spin.cross(body.center())),
               1e-14));

  result("L_y", L[1], "kg m²/s", R"(of which \(\vec r_\CM\times M\vec v_\CM\) is one half)");
  result("T", T, "J", "of which the translation is one half");
}
//! [wheel]

//! [camera]
TEST_CASE("camera: A data sheet for a distant datum has lost the digits of a small part") {
  //! [camera in brief]
  const double M = 1.2;                 // kg: a camera on a satellite
  const Vector3d r_cm(2.1, -1.4, 0.8);  // m, from the datum of the data sheet
  const Matrix3d I_cm = cuboid_about_center(M, 0.15, 0.1, 0.1);
  const Matrix3d I = inertia_from_center_of_mass(I_cm, M, r_cm);
  const Matrix3d printed = (100 * I.array()).round() / 100;  // two decimals
  const Matrix3d recovered = inertia_to_center_of_mass(printed, M, r_cm);
  //! [camera in brief]

  CHECK(agrees(inertia_to_center_of_mass(I, M, r_cm), I_cm, 1e-14, M * r_cm.squaredNorm()));
  CHECK((recovered - I_cm).cwiseAbs().maxCoeff() <= 0.005 + 1e-14);
  CHECK(principal_moments(recovered)[0] < 0);  // no body at all
  // Rounding hurts in proportion to the largest number on the way, M d².
  for (const double distance : {1.0, 1e3, 1e6}) {
    const Vector3d away = distance * r_cm.normalized();
    const Matrix3d back = inertia_to_center_of_mass(inertia_from_center_of_mass(I_cm, M, away), M, away);
    CHECK(agrees(back, I_cm, 1e-15, M * std::max(1.0, distance * distance)));
  }

  result(R"(\mathrm{diag}\,\Inertia)", I.diagonal(), "kg m²", "about the datum", 4);
  result(R"(\mathrm{diag}\,\Inertia_\CM)", I_cm.diagonal(), "kg m²");
  result(R"(\text{recovered: }(I_1, I_2, I_3))", principal_moments(recovered), "kg m²", "no body has a negative moment",
         2);
}
//! [camera]

// Not on the page: shifts follow one another like vectors, at no shift, a tiny one and a large one.
TEST_CASE("laws: Shifts follow one another like vectors") {
  const Points body = four_masses();
  const double M = body.mass();
  const Matrix3d I = body.inertia(), I_cm = inertia_to_center_of_mass(I, M, body.center());
  const Vector3d tiny(1e-8, -2e-8, 1e-8), further(0.2, 0.1, -0.7);

  for (const Vector3d& R : {Vector3d(0, 0, 0), tiny, Vector3d(0.5, -1, 2), Vector3d(1e4, 2e4, -3e4),
                            Vector3d(-body.center()), Vector3d(-2 * body.center())}) {
    const double size = 40 + M * R.squaredNorm();
    const Matrix3d there = inertia_about_shifted_origin(I, M, body.center(), R);
    CHECK(agrees(there, body.moved(R).inertia(), 1e-14, size));
    // There and back again: seen from the new origin the centre of mass is at r_CM + R.
    CHECK(agrees(inertia_about_shifted_origin(there, M, body.center() + R, -R), I, 1e-14, size));
    CHECK(agrees(inertia_about_shifted_origin(there, M, body.center() + R, further),
                 inertia_about_shifted_origin(I, M, body.center(), R + further), 1e-14, size));
  }

  // A tiny shift changes the tensor in first order, but from the centre of mass only in second.
  CHECK((inertia_about_shifted_origin(I, M, body.center(), tiny) - I).norm() > tiny.norm());
  CHECK(agrees(inertia_from_center_of_mass(I_cm, M, tiny), I_cm, 1e-15));
  CHECK(agrees(inertia_from_center_of_mass(I_cm, M, Vector3d::Zero()), I_cm, 1e-15));
  // A body that is nothing but a point; and one body is its own assembly, wherever it lies.
  CHECK(agrees(inertia_from_center_of_mass(Matrix3d::Zero(), 2, Vector3d(1, 2, 3)),
               inertia_of_points(VectorXd{{2}}, Vector3d(1, 2, 3)), 1e-15));
  CHECK(agrees(combined_inertia(VectorXd{{M}}, Vector3d(5, -6, 7), {I_cm}), I_cm, 1e-15));
}
