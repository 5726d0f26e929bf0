// Worked examples of lecture 04. Each case is a paragraph of the notes that computes its own numbers.
#include "lectures/support/agrees.hpp"
#include "lectures/support/printed.hpp"

#include <rigid/inertia_tensor.hpp>
#include <rigid/parallel_axis.hpp>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

using namespace rigid;
using workbook::agrees;
using workbook::Printed;
using workbook::row;

namespace {

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

using Rule = std::vector<std::pair<double, double>>;  // nodes with their weights

/// Seven Gauss points between two limits: exact for polynomials up to degree 13.
Rule gauss_points(double from, double to) {
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  Rule rule;
  for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
    const double x = Gauss::abscissa()[k], weight = Gauss::weights()[k] * (to - from) / 2;
    rule.emplace_back((from + to) / 2 + x * (to - from) / 2, weight);
    if (x != 0) rule.emplace_back((from + to) / 2 - x * (to - from) / 2, weight);
  }
  return rule;
}

/// Eight equal steps around a circle: exact for the sines and cosines of a second moment.
Rule circle_points() {
  Rule rule;
  for (int k = 0; k < 8; ++k) rule.emplace_back(2 * std::numbers::pi * (k + 0.5) / 8, 1.0);
  return rule;
}

/// A uniform body as point masses at the nodes of a quadrature: `place` maps three coordinates to a position, and
/// `volume` is the volume element there, up to a factor.
template <class Place, class Volume>
Points quadrature(double mass, const std::array<Rule, 3>& rules, const Place& place, const Volume& volume) {
  std::vector<double> masses;
  std::vector<Vector3d> places;
  for (const auto& [u, weight_u] : rules[0]) {
    for (const auto& [v, weight_v] : rules[1]) {
      for (const auto& [w, weight_w] : rules[2]) {
        masses.push_back(weight_u * weight_v * weight_w * volume(u, v, w));
        places.push_back(place(u, v, w));
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(masses.size());
  Points points{Eigen::Map<VectorXd>(masses.data(), count), Matrix3Xd(3, count)};
  points.m *= mass / points.m.sum();
  for (Eigen::Index p = 0; p < count; ++p) points.r.col(p) = places[static_cast<std::size_t>(p)];
  return points;
}

/// A tetrahedron with one corner at the origin.
Points tetrahedron(double mass, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Rule unit = gauss_points(0, 1);
  return quadrature(
      mass, {unit, unit, unit},
      [&](double u, double v, double w) -> Vector3d { return u * a + (1 - u) * (v * b + (1 - v) * w * c); },
      [](double u, double v, double) { return (1 - u) * (1 - u) * (1 - v); });
}

}  // namespace

//! [parallel axis]
TEST_CASE("Seen from elsewhere, a body adds the tensor of one mass at its centre") {
  const Points body = four_masses();
  const Points at_center = body.moved(-body.center());
  const Matrix3d I_cm = at_center.inertia();
  const Vector3d d(1, -1, 2);  // from the centre of mass to the point we look from

  const Matrix3d I = inertia_from_center_of_mass(I_cm, body.mass(), d);

  // Point by point: seen from d, the positions are r − d.
  CHECK(agrees(I, at_center.moved(-d).inertia(), 1e-14));
  CHECK(agrees(I, Matrix3d{{69.7, 10, -17.5}, {10, 66.6, 26.4}, {-17.5, 26.4, 28.1}}, 1e-14));
  // What was added is the tensor of a single mass M.
  CHECK(agrees(I - I_cm, inertia_of_points(VectorXd{{body.mass()}}, d), 1e-14));
  // The formula is even: the mirror point has the same tensor.
  CHECK(agrees(inertia_from_center_of_mass(I_cm, body.mass(), -d), I, 1e-15));

  Printed page("parallel axis");
  page.line("about the centre of mass (kg m²):");
  page.matrix(I_cm);
  page.line("about the point {} m from there (kg m²):", row(d));
  page.matrix(I);
}
//! [parallel axis]

//! [to the centre of mass]
TEST_CASE("Back to the centre of mass, where every moment is smallest") {
  const Points body = four_masses();

  const Matrix3d I_cm = inertia_to_center_of_mass(body.inertia(), body.mass(), body.center());

  CHECK(agrees(I_cm, body.moved(-body.center()).inertia(), 1e-14));
  CHECK(agrees(I_cm, Matrix3d{{19.7, 0, 2.5}, {0, 16.6, 6.4}, {2.5, 6.4, 8.1}}, 1e-14));

  // About every axis: what is taken off, M (d² 1 − d d), is the tensor of a mass and has no negative eigenvalue.
  const Vector3d taken_off = principal_moments(body.inertia() - I_cm);
  CHECK(taken_off.minCoeff() >= -1e-13);
  CHECK(agrees(taken_off[0], 0, 1e-13, 1));  // along d itself nothing changes
  CHECK(agrees(taken_off.tail<2>(), body.mass() * body.center().squaredNorm() * Vector2d::Ones(), 1e-13));

  Printed page("to the centre of mass");
  page.line("centre of mass {} m", row(body.center()));
  page.line("I_cm (kg m²) =");
  page.matrix(I_cm);
  page.line("taken off along the principal directions: {} kg m²", row(taken_off, "{:.6g}"));
}
//! [to the centre of mass]

//! [shifted origin]
TEST_CASE("The slides' formula: from any origin to any other") {
  const Points body = four_masses();
  const Vector3d R(0.5, -1, 2);

  const Matrix3d I = inertia_about_shifted_origin(body.inertia(), body.mass(), body.center(), R);

  // By definition every position becomes r' = r + R.
  CHECK(agrees(I, body.moved(R).inertia(), 1e-14));
  CHECK(agrees(I, Matrix3d{{129, 2, -30.5}, {2, 135.5, 13}, {-30.5, 13, 18.5}}, 1e-14));
  // In two steps over the centre of mass, whose position becomes r_CM + R.
  const Matrix3d I_cm = inertia_to_center_of_mass(body.inertia(), body.mass(), body.center());
  CHECK(agrees(I, inertia_from_center_of_mass(I_cm, body.mass(), body.center() + R), 1e-14));

  // The classic mistake: the parallel-axis theorem used from a point that is not the centre of mass.
  const Matrix3d mistaken = inertia_from_center_of_mass(body.inertia(), body.mass(), R);
  CHECK_FALSE(agrees(mistaken, I, 0.1));

  Printed page("shifted origin");
  page.line("I about the point {} m (kg m²):", row(-R));
  page.matrix(I);
  page.line("without the terms in r_CM (kg m²), wrong:");
  page.matrix(mistaken);
}
//! [shifted origin]

//! [direction of R]
TEST_CASE("R points from the new origin to the old one") {
  const Points body = four_masses();
  const Vector3d new_origin(-0.5, 1, -2);
  const Matrix3d right = body.moved(-new_origin).inertia();  // what one sees from there

  // r' = r + R is r minus the new origin's position, so R = −(new origin).
  CHECK(agrees(inertia_about_shifted_origin(body.inertia(), body.mass(), body.center(), -new_origin), right, 1e-14));

  // With the arrow reversed one gets the tensor about the mirror point, a perfectly good tensor of the wrong place.
  const Matrix3d reversed = inertia_about_shifted_origin(body.inertia(), body.mass(), body.center(), new_origin);
  CHECK(agrees(reversed, body.moved(new_origin).inertia(), 1e-14));
  CHECK_FALSE(agrees(reversed, right, 0.1));

  // The difference is 2 M (2 r_CM·R 1 − r_CM R − R r_CM). With the origin at the centre of mass nothing is left of it.
  const Points centered = body.moved(-body.center());
  CHECK(agrees(inertia_about_shifted_origin(centered.inertia(), body.mass(), Vector3d::Zero(), new_origin),
               inertia_about_shifted_origin(centered.inertia(), body.mass(), Vector3d::Zero(), -new_origin), 1e-14));

  Printed page("direction of R");
  page.line("R = old − new: moments {} kg m²", row(principal_moments(right), "{:.6g}"));
  page.line("R reversed:    moments {} kg m²", row(principal_moments(reversed), "{:.6g}"));
}
//! [direction of R]

//! [cuboid from corner to centre]
TEST_CASE("The slides' cuboid: from the corner to the centre, 1/3 − 1/4 = 1/12") {
  const double M = 6, a = 1, b = 2, c = 3;
  const Matrix3d corner = cuboid_about_corner(M, a, b, c);
  const Vector3d R(-a / 2, -b / 2, -c / 2);  // with the minus that the text of S0 s14 lost

  const Matrix3d center = inertia_about_shifted_origin(corner, M, -R, R);

  CHECK(agrees(center, cuboid_about_center(M, a, b, c), 1e-14));
  CHECK(agrees(center, Matrix3d(Vector3d(6.5, 5, 2.5).asDiagonal()), 1e-14));
  // For this R the general formula is I − M (R² 1 − R R), and each third of the corner loses its quarter.
  CHECK(agrees(center, corner - inertia_of_points(VectorXd{{M}}, R), 1e-14));

  // That short form is even in R and cannot tell R from −R. The general formula can: with +R the new origin would lie
  // as far beyond the corner as the centre lies inside.
  const Matrix3d beyond = inertia_about_shifted_origin(corner, M, -R, -R);
  CHECK(agrees(beyond, inertia_from_center_of_mass(center, M, 2 * R), 1e-14));
  CHECK(agrees(beyond(0, 0), center(0, 0) + M * (b * b + c * c), 1e-14));

  Printed page("cuboid from corner to centre");
  page.line("about the corner (kg m²):");
  page.matrix(corner);
  page.line("about the centre (kg m²):");
  page.matrix(center);
  page.line("with R reversed (kg m²):");
  page.matrix(beyond);
}
//! [cuboid from corner to centre]

//! [cuboid by slices]
TEST_CASE("1/12 from the parallel-axis theorem alone, without an integral") {
  // A rod of length a is two rods of half the length and half the mass, a quarter of a away from the middle. If the
  // moment is x M a², then x M a² = 2 [x (M/2) (a/2)² + (M/2) (a/4)²], that is x = x/4 + 1/16.
  double x = 0;
  for (int halving = 0; halving < 40; ++halving) x = x / 4 + 1.0 / 16;
  CHECK(agrees(x, 1.0 / 12, 1e-15));
  CHECK(agrees(cuboid_about_center(1, 1, 0, 0)(1, 1), x, 1e-15));

  // The same for the cuboid, with the pieces put together by the workbook's own function.
  const double M = 6, a = 1, b = 2, c = 3, cut = 0.3;  // two unequal pieces, cut across x
  Matrix3Xd centers = Matrix3Xd::Zero(3, 2);
  centers.row(0) << cut / 2, (cut + a) / 2;
  const VectorXd masses = VectorXd{{M * cut / a, M * (a - cut) / a}};
  const Matrix3d whole = combined_inertia(
      masses, centers, {cuboid_about_center(masses[0], cut, b, c), cuboid_about_center(masses[1], a - cut, b, c)});
  CHECK(agrees(whole, cuboid_about_center(M, a, b, c), 1e-14));

  Printed page("cuboid by slices");
  page.line("x = x/4 + 1/16 has the solution {:.12g} = 1/12", x);
  page.line("cut and put together again: moments {} kg m²", row(whole.diagonal()));
}
//! [cuboid by slices]

//! [two bodies]
TEST_CASE("Two bodies fixed to each other turn about their common centre of mass") {
  Matrix3Xd centers(3, 2);
  centers << 0, 1, 0, 2, 0, 3;
  const VectorXd masses{{2, 3}};
  const Matrix3d first = Vector3d(1, 2, 2.5).asDiagonal(), second = Vector3d(0.5, 0.6, 0.7).asDiagonal();

  const Matrix3d I = combined_inertia(masses, centers, {first, second});

  CHECK(agrees(I, Matrix3d{{17.1, -2.4, -3.6}, {-2.4, 14.6, -7.2}, {-3.6, -7.2, 9.2}}, 1e-14));
  // Without the common centre: the pair acts as one reduced mass m₁m₂/(m₁ + m₂) at the distance of the two centres.
  const double reduced = masses[0] * masses[1] / masses.sum();
  CHECK(agrees(I, first + second + inertia_of_points(VectorXd{{reduced}}, centers.col(1) - centers.col(0)), 1e-14));
  // About the origin first, then back to the common centre.
  const Matrix3d about_origin = first + inertia_from_center_of_mass(second, masses[1], centers.col(1));
  CHECK(agrees(I, inertia_to_center_of_mass(about_origin, masses.sum(), centers * masses / masses.sum()), 1e-14));

  Printed page("two bodies");
  page.line("common centre of mass {} m", row(centers * masses / masses.sum()));
  page.line("I (kg m²) =");
  page.matrix(I);
}
//! [two bodies]

//! [moving origin]
TEST_CASE("About an origin that moves, the energy has two more terms") {
  const Points body = four_masses();
  const Vector3d omega(0.3, -0.2, 0.5), v_origin(0.4, 1.1, -0.6);

  // Point by point: each mass has the velocity of the origin and ω × r besides.
  double by_points = 0;
  for (int p = 0; p < body.m.size(); ++p) {
    by_points += 0.5 * body.m[p] * (v_origin + omega.cross(Vector3d(body.r.col(p)))).squaredNorm();
  }

  const double rotation = kinetic_energy(body.inertia(), omega);
  const double mixed = body.mass() * v_origin.dot(omega.cross(body.center()));
  const double translation = 0.5 * body.mass() * v_origin.squaredNorm();
  CHECK(agrees(rotation + mixed + translation, by_points, 1e-14));

  // About the centre of mass the mixed term vanishes: that is what makes it the best of all moving origins.
  const Vector3d v_center = v_origin + omega.cross(body.center());
  const Matrix3d I_cm = inertia_to_center_of_mass(body.inertia(), body.mass(), body.center());
  CHECK(agrees(kinetic_energy(I_cm, omega) + 0.5 * body.mass() * v_center.squaredNorm(), by_points, 1e-14));

  Printed page("moving origin");
  page.line("½ ω·I·ω = {:.6g} J, M v·(ω × r_CM) = {:.6g} J, ½ M v² = {:.6g} J", rotation, mixed, translation);
  page.line("sum {:.6g} J, point by point {:.6g} J", rotation + mixed + translation, by_points);
  page.line("about the centre of mass: {:.6g} J + {:.6g} J", kinetic_energy(I_cm, omega),
            0.5 * body.mass() * v_center.squaredNorm());
}
//! [moving origin]

//! [far away]
TEST_CASE("From far away the way back costs digits") {
  const double M = 7;
  const Matrix3d I_cm = cuboid_about_center(M, 1, 2, 3);
  const Vector3d direction = Vector3d(1, 2, -1).normalized();

  Printed page("far away");
  for (const double distance : {1.0, 1e3, 1e6}) {
    const Vector3d r_cm = distance * direction;
    const Matrix3d there = inertia_from_center_of_mass(I_cm, M, r_cm);
    const Matrix3d back = inertia_to_center_of_mass(there, M, r_cm);
    // Rounding hurts in proportion to the largest number on the way, M d².
    CHECK(agrees(back, I_cm, 1e-15, M * std::max(1.0, distance * distance)));
    page.line("from {:7g} m and back: error {:.0e} kg m²", distance, (back - I_cm).cwiseAbs().maxCoeff());
  }
}
//! [far away]

//! [laws]
TEST_CASE("Shifts follow one another like vectors, and the laws hold at hard arguments") {
  const Points body = four_masses();
  const double M = body.mass();
  const Matrix3d I = body.inertia();

  // No shift, a tiny one, an ordinary one, a large one, and the exact way to the centre of mass and to its mirror
  // point.
  for (const Vector3d& R : {Vector3d(0, 0, 0), Vector3d(1e-8, -2e-8, 1e-8), Vector3d(0.5, -1, 2),
                            Vector3d(1e4, 2e4, -3e4), Vector3d(-body.center()), Vector3d(-2 * body.center())}) {
    const double size = 40 + M * R.squaredNorm();
    const Matrix3d there = inertia_about_shifted_origin(I, M, body.center(), R);
    CHECK(agrees(there, body.moved(R).inertia(), 1e-14, size));
    // There and back again: seen from the new origin the centre of mass is at r_CM + R.
    CHECK(agrees(inertia_about_shifted_origin(there, M, body.center() + R, -R), I, 1e-14, size));
    // Two shifts are one.
    const Vector3d further(0.2, 0.1, -0.7);
    CHECK(agrees(inertia_about_shifted_origin(there, M, body.center() + R, further),
                 inertia_about_shifted_origin(I, M, body.center(), R + further), 1e-14, size));
  }

  // A tiny shift from another origin than the centre of mass changes the tensor in first order, from the centre only in
  // second: the tensor is stationary there.
  const Vector3d tiny(1e-8, -2e-8, 1e-8);
  const Matrix3d first_order = (inertia_about_shifted_origin(I, M, body.center(), tiny) - I) / tiny.norm();
  CHECK(first_order.norm() > 1);
  const Matrix3d I_cm = inertia_to_center_of_mass(I, M, body.center());
  CHECK(agrees(inertia_from_center_of_mass(I_cm, M, tiny), I_cm, 1e-15));

  // A body without mass at its own centre, and one that is nothing but a point.
  CHECK(agrees(inertia_from_center_of_mass(I_cm, M, Vector3d::Zero()), I_cm, 1e-15));
  CHECK(agrees(inertia_from_center_of_mass(Matrix3d::Zero(), 2, Vector3d(1, 2, 3)),
               inertia_of_points(VectorXd{{2}}, Vector3d(1, 2, 3)), 1e-15));
  // One body is its own assembly, wherever it lies.
  CHECK(agrees(combined_inertia(VectorXd{{M}}, Vector3d(5, -6, 7), {I_cm}), I_cm, 1e-15));
}
//! [laws]

//! [not always diagonal]
TEST_CASE("The centre of mass does not make a tensor diagonal; symmetry does") {
  // The slides warn: the cuboid is a special case. Take half of it, cut along a face diagonal (a wedge).
  const double M = 3, a = 1, b = 2, c = 3;
  const Rule unit = gauss_points(0, 1);
  const Points wedge = quadrature(
      M, {unit, unit, unit}, [=](double u, double v, double w) { return Vector3d(a * u, b * v * (1 - u), c * w); },
      [](double u, double, double) { return 1 - u; });

  const Matrix3d I_cm = inertia_to_center_of_mass(wedge.inertia(), M, wedge.center());

  CHECK(agrees(wedge.center(), Vector3d(a / 3, b / 3, c / 2), 1e-14));
  CHECK(agrees(I_cm(0, 1), M * a * b / 36, 1e-13));  // −M <xy> about the centre of mass of the triangle
  CHECK(agrees(I_cm(0, 2), 0, 1e-14, 1));            // the wedge still has a mirror plane across z
  CHECK(agrees(I_cm(1, 2), 0, 1e-14, 1));

  // Two wedges make the cuboid, and their products cancel.
  const Vector3d other_center = Vector3d(a, b, c) - wedge.center();
  Matrix3Xd centers(3, 2);
  centers << wedge.center(), other_center;
  CHECK(agrees(combined_inertia(VectorXd{{M, M}}, centers, {I_cm, I_cm}), cuboid_about_center(2 * M, a, b, c), 1e-14));

  Printed page("not always diagonal");
  page.line("half a cuboid about its centre of mass: I_xy = {:.6g} kg m², moments on the diagonal {} kg m²", I_cm(0, 1),
            row(I_cm.diagonal(), "{:.6g}"));
}
//! [not always diagonal]

//! [V02]
TEST_CASE("V02 A cone about its apex, and about its centre of mass") {
  // Wikipedia, "List of moments of inertia", inertia tensors: solid cone about its apex.
  const double m = 1, r = 1, h = 2;
  const Points cone = quadrature(
      m, {gauss_points(0, 1), gauss_points(0, 1), circle_points()},
      [=](double u, double v, double angle) {
        return Vector3d(r * u * v * std::cos(angle), r * u * v * std::sin(angle), h * u);
      },
      [](double u, double v, double) { return u * u * v; });
  CHECK(agrees(cone.center(), Vector3d(0, 0, 0.75 * h), 1e-14));

  const Matrix3d I_cm = inertia_to_center_of_mass(cone.inertia(), m, cone.center());
  // This cone, twice as high as its base is wide in radius, turns about its centre of mass like a sphere.
  CHECK(agrees(I_cm, 0.3 * Matrix3d::Identity(), 1e-12));
  const Matrix3d apex = inertia_from_center_of_mass(Vector3d::Constant(0.3).asDiagonal(), m, Vector3d(0, 0, 0.75 * h));
  CHECK(agrees(apex, Matrix3d(Vector3d(2.55, 2.55, 0.3).asDiagonal()), 1e-12));
  CHECK(agrees(cone.inertia(), apex, 1e-12));

  Printed page("V02");
  page.line("V02 | (2.55, 2.55, 0.3) | {} | 1e-12", row(apex.diagonal(), "{:.12g}"));
}
//! [V02]

//! [V03]
TEST_CASE("V03 A solid ellipsoid, also from the tip of an axis") {
  // Wikipedia, "List of moments of inertia", inertia tensors: solid ellipsoid with half axes 1, 2, 3.
  const double m = 5;
  const Vector3d half_axes(1, 2, 3);
  const Points ellipsoid = quadrature(
      m, {gauss_points(0, 1), gauss_points(-1, 1), circle_points()},
      [&](double radius, double cosine, double angle) -> Vector3d {
        const double sine = std::sqrt(1 - cosine * cosine);
        return radius * half_axes.cwiseProduct(Vector3d(sine * std::cos(angle), sine * std::sin(angle), cosine));
      },
      [](double radius, double, double) { return radius * radius; });

  // From the tip of the longest axis, then back to the centre.
  const Vector3d tip(0, 0, 3);
  const Matrix3d about_tip = ellipsoid.moved(-tip).inertia();
  const Matrix3d I = inertia_to_center_of_mass(about_tip, m, -tip);
  CHECK(agrees(I, Matrix3d(Vector3d(13, 10, 5).asDiagonal()), 1e-12));
  CHECK(agrees(about_tip, inertia_from_center_of_mass(Vector3d(13, 10, 5).asDiagonal(), m, tip), 1e-12));

  Printed page("V03");
  page.line("V03 | (13, 10, 5) | {} | 1e-12", row(I.diagonal(), "{:.12g}"));
}
//! [V03]

//! [V04]
TEST_CASE("V04 A uniform cylinder, cut in two and put together again") {
  // NASA NESC flight simulation check cases, "bodies": 1000 kg, 12 m long; the 1 m stated twice there is the radius.
  const double m = 1000, length = 12, radius = 1;
  const auto cylinder = [&](double mass, double from, double to) {
    return quadrature(
        mass, {gauss_points(from, to), gauss_points(0, radius), circle_points()},
        [](double x, double rho, double angle) { return Vector3d(x, rho * std::cos(angle), rho * std::sin(angle)); },
        [](double, double rho, double) { return rho; });
  };
  const Points front = cylinder(0.3 * m, 0, 0.3 * length), rear = cylinder(0.7 * m, 0.3 * length, length);

  Matrix3Xd centers(3, 2);
  centers << front.center(), rear.center();
  const Matrix3d I = combined_inertia(VectorXd{{front.mass(), rear.mass()}}, centers,
                                      {front.moved(-front.center()).inertia(), rear.moved(-rear.center()).inertia()});

  CHECK(agrees(I, Matrix3d(Vector3d(500, 12250, 12250).asDiagonal()), 1e-12));
  CHECK(agrees(I, inertia_to_center_of_mass(cylinder(m, 0, length).inertia(), m, Vector3d(length / 2, 0, 0)), 1e-12));

  Printed page("V04");
  page.line("V04 | (500, 12250, 12250) | {} | 1e-12", row(I.diagonal(), "{:.12g}"));
}
//! [V04]

//! [V06]
TEST_CASE("V06 The regular tetrahedron and the regular octahedron behave like spheres") {
  // Wikipedia, "List of moments of inertia": m s²/20 and m s²/10 about the centre, for edges s.
  const double side = 1 / std::sqrt(2.0);  // (±1, ±1, …)/√2 are 1 apart
  const Points tetra = tetrahedron(1, side * Vector3d(1, 1, 0), side * Vector3d(1, 0, 1), side * Vector3d(0, 1, 1));
  const Matrix3d of_tetrahedron = inertia_to_center_of_mass(tetra.inertia(), 1, tetra.center());
  CHECK(agrees(of_tetrahedron, 0.05 * Matrix3d::Identity(), 1e-12));

  // The octahedron is eight irregular tetrahedra from its centre to its faces, each an eighth of the mass.
  VectorXd masses = VectorXd::Constant(8, 1.0 / 8);
  Matrix3Xd centers(3, 8);
  std::vector<Matrix3d> tensors;
  for (int p = 0; p < 8; ++p) {
    const auto corner = [&](int axis) -> Vector3d { return (p >> axis & 1 ? -side : side) * Vector3d::Unit(axis); };
    const Points piece = tetrahedron(1.0 / 8, corner(0), corner(1), corner(2));
    centers.col(p) = piece.center();
    tensors.push_back(inertia_to_center_of_mass(piece.inertia(), piece.mass(), piece.center()));
  }
  const Matrix3d of_octahedron = combined_inertia(masses, centers, tensors);
  CHECK(agrees(of_octahedron, 0.1 * Matrix3d::Identity(), 1e-12));

  Printed page("V06");
  page.line("V06 | 1/20, 1/10 | {:.12g}, {:.12g} | 1e-12", of_tetrahedron(0, 0), of_octahedron(0, 0));
}
//! [V06]

//! [V10]
TEST_CASE("V10 A point mass, and a shift within the xy plane") {
  // SymPy, tests of its inertia functions: a point mass at (r, s, t); a body shifted by (a, b, 0).
  const double m = 1.7, r = 0.3, s = -1.2, t = 2.1;
  const Matrix3d of_point = inertia_from_center_of_mass(Matrix3d::Zero(), m, Vector3d(r, s, t));
  CHECK(agrees(
      of_point,
      m * Matrix3d{{s * s + t * t, -r * s, -r * t}, {-r * s, r * r + t * t, -s * t}, {-r * t, -s * t, r * r + s * s}},
      1e-14));

  const double Ix = 2, Iy = 3, Iz = 4, a = 0.8, b = -1.5;
  const Matrix3d expected{
      {Ix + m * b * b, -m * a * b, 0}, {-m * a * b, Iy + m * a * a, 0}, {0, 0, Iz + m * (a * a + b * b)}};
  const Matrix3d shifted = inertia_from_center_of_mass(Vector3d(Ix, Iy, Iz).asDiagonal(), m, Vector3d(a, b, 0));
  CHECK(agrees(shifted, expected, 1e-14));

  Printed page("V10");
  page.line("V10 | I_xy = −m a b = {:.12g} | {:.12g} | 1e-14", -m * a * b, shifted(0, 1));
}
//! [V10]
