// Inertia tensors of bodies that tables list, by quadrature and the functions that change the origin.
#include "tests/cases/problems.hpp"

#include <rigid/inertia_tensor.hpp>
#include <rigid/parallel_axis.hpp>

#include <boost/math/quadrature/gauss.hpp>

#include <array>
#include <utility>
#include <vector>

namespace tabulated_bodies {

namespace {

struct Points {
  VectorXd m;
  Matrix3Xd r;

  double mass() const { return m.sum(); }
  Vector3d center() const { return r * m / m.sum(); }
  Matrix3d inertia() const { return inertia_of_points(m, r); }
  Matrix3d inertia_about_center() const { return inertia_to_center_of_mass(inertia(), mass(), center()); }
};

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

/// Eight equal steps round a circle: exact for the sines and cosines of a second moment.
Rule circle_points() {
  Rule rule;
  for (int k = 0; k < 8; ++k) rule.emplace_back(2 * std::numbers::pi * (k + 0.5) / 8, 1.0);
  return rule;
}

/// A uniform body as point masses at the nodes: `place` maps three coordinates to a position, and `volume` is the
/// volume element there, up to a factor.
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

Matrix3d diagonal(double x, double y, double z) { return Vector3d(x, y, z).asDiagonal(); }

}  // namespace

TEST_CASE("a cone about its apex and about its centre of mass: Wikipedia, list of moments of inertia") {
  const double m = 1, r = 1, h = 2;
  const Points cone = quadrature(
      m, {gauss_points(0, 1), gauss_points(0, 1), circle_points()},
      [=](double u, double v, double angle) {
        return Vector3d(r * u * v * std::cos(angle), r * u * v * std::sin(angle), h * u);
      },
      [](double u, double v, double) { return u * u * v; });
  CHECK(agrees(cone.center(), Vector3d(0, 0, 0.75 * h), 1e-14));
  CHECK(agrees(cone.inertia(), diagonal(2.55, 2.55, 0.3), 1e-12));
  CHECK(agrees(cone.inertia_about_center(), diagonal(0.3, 0.3, 0.3), 1e-12));
  CHECK(agrees(inertia_from_center_of_mass(diagonal(0.3, 0.3, 0.3), m, Vector3d(0, 0, 0.75 * h)),
               diagonal(2.55, 2.55, 0.3), 1e-12));
}

TEST_CASE("a solid ellipsoid about its centre and about the tip of its longest axis: Wikipedia") {
  const double m = 5;
  const Vector3d half_axes(1, 2, 3);
  Points ellipsoid = quadrature(
      m, {gauss_points(0, 1), gauss_points(-1, 1), circle_points()},
      [&](double radius, double cosine, double angle) -> Vector3d {
        const double sine = std::sqrt(1 - cosine * cosine);
        return radius * half_axes.cwiseProduct(Vector3d(sine * std::cos(angle), sine * std::sin(angle), cosine));
      },
      [](double radius, double, double) { return radius * radius; });
  ellipsoid.r.row(2).array() -= 3;  // seen from the tip
  CHECK(agrees(ellipsoid.inertia(), inertia_from_center_of_mass(diagonal(13, 10, 5), m, Vector3d(0, 0, 3)), 1e-12));
  CHECK(agrees(ellipsoid.inertia_about_center(), diagonal(13, 10, 5), 1e-12));
}

TEST_CASE("a uniform cylinder, cut in two and put together: NASA Engineering and Safety Center, bodies") {
  // 12 m long; the 1 m stated twice there is the radius.
  const auto cylinder = [&](double mass, double from, double to) {
    return quadrature(
        mass, {gauss_points(from, to), gauss_points(0, 1), circle_points()},
        [](double x, double rho, double angle) { return Vector3d(x, rho * std::cos(angle), rho * std::sin(angle)); },
        [](double, double rho, double) { return rho; });
  };
  const Points front = cylinder(300, 0, 3.6), rear = cylinder(700, 3.6, 12);
  Matrix3Xd centers(3, 2);
  centers << front.center(), rear.center();
  CHECK(agrees(
      combined_inertia(VectorXd{{300, 700}}, centers, {front.inertia_about_center(), rear.inertia_about_center()}),
      diagonal(500, 12250, 12250), 1e-12));
  CHECK(agrees(cylinder(1000, 0, 12).inertia_about_center(), diagonal(500, 12250, 12250), 1e-12));
}

TEST_CASE("the regular tetrahedron and octahedron of edge 1 m about their centres: Wikipedia") {
  // A tetrahedron with one corner at the origin.
  const auto tetrahedron = [](double mass, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Rule unit = gauss_points(0, 1);
    return quadrature(
        mass, {unit, unit, unit},
        [&](double u, double v, double w) -> Vector3d { return u * a + (1 - u) * (v * b + (1 - v) * w * c); },
        [](double u, double v, double) { return (1 - u) * (1 - u) * (1 - v); });
  };
  const double side = 1 / std::sqrt(2.0);
  const Points regular = tetrahedron(1, side * Vector3d(1, 1, 0), side * Vector3d(1, 0, 1), side * Vector3d(0, 1, 1));
  CHECK(agrees(regular.inertia_about_center(), diagonal(0.05, 0.05, 0.05), 1e-12));

  // The octahedron: eight tetrahedra from its centre to its faces.
  Matrix3Xd centers(3, 8);
  std::vector<Matrix3d> tensors;
  for (int p = 0; p < 8; ++p) {
    const auto corner = [&](int axis) -> Vector3d { return (p >> axis & 1 ? -side : side) * Vector3d::Unit(axis); };
    const Points piece = tetrahedron(1.0 / 8, corner(0), corner(1), corner(2));
    centers.col(p) = piece.center();
    tensors.push_back(piece.inertia_about_center());
  }
  CHECK(agrees(combined_inertia(VectorXd::Constant(8, 1.0 / 8), centers, tensors), diagonal(0.1, 0.1, 0.1), 1e-12));
}

TEST_CASE("a point mass, and a shift within the x-y plane: tests of SymPy") {
  const double m = 1.7, r = 0.3, s = -1.2, t = 2.1;
  const Matrix3d point{
      {s * s + t * t, -r * s, -r * t}, {-r * s, r * r + t * t, -s * t}, {-r * t, -s * t, r * r + s * s}};
  CHECK(agrees(inertia_from_center_of_mass(Matrix3d::Zero(), m, Vector3d(r, s, t)), m * point, 1e-14));

  const double a = 0.8, b = -1.5;
  const Matrix3d shifted{
      {2 + m * b * b, -m * a * b, 0}, {-m * a * b, 3 + m * a * a, 0}, {0, 0, 4 + m * (a * a + b * b)}};
  CHECK(agrees(inertia_from_center_of_mass(diagonal(2, 3, 4), m, Vector3d(a, b, 0)), shifted, 1e-14));
}

}  // namespace tabulated_bodies
