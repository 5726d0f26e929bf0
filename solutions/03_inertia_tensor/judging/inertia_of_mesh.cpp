#include "solutions/03_inertia_tensor/shared.hpp"

#include <array>
#include <map>

/// A surface by the numbers of its corners, three for each triangle.
using Faces = std::vector<int>;
static const Faces of_tetrahedron{0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 2, 1};
/// Corners +x, −x, +y, −y, +z, −z.
static const Faces of_octahedron{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
static const Faces of_block{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                            2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};

static Matrix3Xd surface(const Matrix3Xd& points, const Faces& faces) {
  Matrix3Xd corners(3, std::ssize(faces));
  for (int k = 0; k < corners.cols(); ++k) corners.col(k) = points.col(faces[static_cast<std::size_t>(k)]);
  return corners;
}

static Matrix3Xd corners_of_block(const Vector3d& from, const Vector3d& to) {
  Matrix3Xd points(3, 8);
  for (int p = 0; p < 8; ++p) {
    for (int i = 0; i < 3; ++i) points(i, p) = p >> i & 1 ? to[i] : from[i];
  }
  return points;
}

static Matrix3Xd with_hollow(const Matrix3Xd& outer, const Matrix3Xd& inner) {
  Matrix3Xd both(3, outer.cols() + inner.cols());
  both << outer, inner.rowwise().reverse();  // a hollow is seen from its inside
  return both;
}

static bool is_closed_surface(const Matrix3Xd& corners) {
  if (corners.cols() % 3 != 0) return false;
  std::map<std::array<double, 6>, int> surplus;  // of an edge over the same edge in the opposite sense
  for (Eigen::Index k = 0; k < corners.cols(); ++k) {
    const Vector3d from = corners.col(k), to = corners.col(k % 3 == 2 ? k - 2 : k + 1);
    ++surplus[{from[0], from[1], from[2], to[0], to[1], to[2]}];
    --surplus[{to[0], to[1], to[2], from[0], from[1], from[2]}];
  }
  return std::ranges::all_of(surplus, [](const auto& edge) { return edge.second == 0; });
}

/// The tensor from Σ f(T, V): T has the corners of a triangle as columns, V is the signed volume between it and the
/// origin, and f gives second moments.
template <class F>
static Matrix3d tensor_from(const Matrix3Xd& corners, double density, const F& f) {
  Matrix3d C = Matrix3d::Zero();
  for (Eigen::Index k = 0; k + 2 < corners.cols(); k += 3) {
    const Matrix3d T = corners.middleCols<3>(k);
    C += f(T, T.determinant() / 6);
  }
  return density * (C.trace() * Matrix3d::Identity() - C);
}

static Vector3d sum_of_corners(const Matrix3d& T) { return T.rowwise().sum(); }

/// Volume, and volume times centre of mass.
static std::pair<double, Vector3d> volume_and_first_moment(const Matrix3Xd& corners) {
  std::pair<double, Vector3d> sum{0, zero};
  tensor_from(corners, 1, [&](const Matrix3d& T, double V) -> Matrix3d {
    sum.first += V;
    sum.second += V / 4 * sum_of_corners(T);
    return Matrix3d::Zero();
  });
  return sum;
}

/// ∮ r r (r·n) dA = 5 ∫ r r dV; on a triangle the midpoints of the edges integrate r r exactly.
static Matrix3d by_divergence_theorem(const Matrix3Xd& corners, double density) {
  return tensor_from(corners, density, [](const Matrix3d& T, double V) {
    return V / 20 * (dyad(T.col(0) + T.col(1)) + dyad(T.col(1) + T.col(2)) + dyad(T.col(2) + T.col(0)));
  });
}

/// In each tetrahedron four points, which are exact for squares.
static Matrix3d by_points_in_tetrahedra(const Matrix3Xd& corners, double density) {
  const double near = (5 + 3 * sqrt(5.0)) / 20, far = (5 - sqrt(5.0)) / 20;
  return tensor_from(corners, density, [=](const Matrix3d& T, double V) {
    const Vector3d base = far * sum_of_corners(T);
    const Matrix3d points = ((near - far) * T).colwise() + base;
    return V / 4 * (dyad(base) + points * points.transpose());
  });
}

/// The columns between each triangle and the plane z = 0, with three Gauss points in each direction.
static Matrix3d by_columns_above_a_plane(const Matrix3Xd& corners, double density) {
  const std::array<std::pair<double, double>, 3> gauss{
      {{0.5 - sqrt(0.15), 5. / 18}, {0.5, 8. / 18}, {0.5 + sqrt(0.15), 5. / 18}}};
  return tensor_from(corners, density, [&](const Matrix3d& T, double) {
    Matrix3d sum = Matrix3d::Zero();
    const Vector3d along = T.col(1) - T.col(0), across = T.col(2) - T.col(1);
    const double shadow = cross(along, across).z();  // twice its area, with the sign of the upward normal
    for (const auto& [u, of_u] : gauss) {
      for (const auto& [v, of_v] : gauss) {
        const Vector3d top = T.col(0) + u * (along + v * across);
        for (const auto& [w, of_w] : gauss)
          sum += of_u * of_v * of_w * u * shadow * top.z() * dyad({top.x(), top.y(), w * top.z()});
      }
    }
    return sum;
  });
}

static Matrix3Xd turned_and_shifted(Random& random, const Matrix3Xd& points) {
  const Matrix3Xd turned = random.rotation() * points;
  const Vector3d shift = random.vector(2);
  return turned.colwise() + shift;
}

void judge_inertia_of_mesh(Lecture& lecture) {
  auto& e = lecture.exercise(&inertia_of_mesh, {{"corners", metre}, {"density", positive(kg / metre / metre / metre)}},
                             {"I", kg_m2});
  e.domain(
      [](auto& r, auto) { return is_closed_surface(r) && (r.cols() == 0 || volume_and_first_moment(r).first > 0); });
  e.scale([](auto& r, auto density) { return or_one(inertia_of_mesh(r, density).norm()); });
  const auto tetrahedron = [](double s) {
    return surface(Matrix3Xd{{1, 0, 0, s}, {0, 2, 0, s}, {0, 0, 3, s}}, of_tetrahedron);
  };
  const Matrix3Xd block = surface(corners_of_block({0, 0, 0}, {1, 2, 3}), of_block);
  const Matrix3Xd on_the_axes{{1, -1, 0, 0, 0, 0}, {0, 0, 1, -1, 0, 0}, {0, 0, 0, 0, 1, -1}};
  e.worked("a tetrahedron, the origin outside", tetrahedron(1), 2);
  e.worked("a block with a corner at the origin", block, 1);
  e.special("the block with a hollow",
            with_hollow(block, surface(corners_of_block({0.2, 0.3, 0.5}, {0.7, 1.1, 2}), of_block)), 1);
  e.special("an octahedron about its centre", surface(on_the_axes, of_octahedron), 1.5);
  e.special("no triangle", Matrix3Xd(3, 0), 1);
  e.limit("no triangle", Matrix3d::Zero(), "There is no body.");
  e.limit("a block with a corner at the origin", Matrix3d{{26, -3, -4.5}, {-3, 20, -9}, {-4.5, -9, 10}},
          "It is the cuboid about its corner of the exercise before, whatever its surface is cut into.");
  e.random("a tetrahedron", 4, [](Random& random) {
    const Matrix3Xd points = Matrix3Xd{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}} + 0.1 * random.points(4);
    return tuple(surface(turned_and_shifted(random, points), of_tetrahedron), random.uniform(0.5, 4));
  });
  e.random("a bowl", 3, [=](Random& random) {
    Matrix3Xd points = on_the_axes + 0.1 * random.points(6);
    points(2, 4) = random.uniform(-0.5, -0.3);
    return tuple(surface(turned_and_shifted(random, points), of_octahedron), random.uniform(0.5, 4));
  });
  e.random("a block with a hollow", 3, [](Random& random) {
    Matrix3Xd points(3, 16);
    points << corners_of_block({0, 0, 0}, {1, 1.5, 2.5}), corners_of_block({0.2, 0.2, 0.3}, {0.5, 0.9, 1.4});
    points = turned_and_shifted(random, points);
    return tuple(with_hollow(surface(points.leftCols(8), of_block), surface(points.rightCols(8), of_block)),
                 random.uniform(0.5, 4));
  });
  e.sweep({"A tetrahedron with the corners (1, 0, 0), (0, 2, 0), (0, 0, 3), (s, s, s) m and 2 kg/m³",
           "place of the fourth corner, s (m)", "entry of I (kg m²)"},
          {"I_xx", {"I_zz", 2, 2}, {"I_xy", 0, 1}}, {0.6, 2}, [=](auto s) { return tuple(tetrahedron(s), 2.0); });

  e.wrong("All tetrahedra are added; those whose face is seen from the origin on its outer side are to be subtracted.",
          "absolute_volumes", [](auto& r, auto density) {
            return tensor_from(r, density, [](const Matrix3d& T, double V) {
              return abs(V) / 20 * (T * T.transpose() + dyad(sum_of_corners(T)));
            });
          });
  e.wrong("Each tetrahedron counts as a point mass at its centroid; it also has moments about its centroid.",
          "centroids", [](auto& r, auto density) {
            return tensor_from(r, density,
                               [](const Matrix3d& T, double V) { return V / 16 * dyad(sum_of_corners(T)); });
          });
  e.wrong("Each tetrahedron counts as four quarters of its mass at its corners; that is too far out.", "corners",
          [](auto& r, auto density) {
            return tensor_from(r, density, [](const Matrix3d& T, double V) { return V / 4 * (T * T.transpose()); });
          });
  e.wrong("Two different corners count twice as much as a corner with itself here; it is the other way round.",
          "weights_exchanged", [](auto& r, auto density) {
            return tensor_from(r, density, [](const Matrix3d& T, double V) {
              return V / 20 * (2 * dyad(sum_of_corners(T)) - T * T.transpose());
            });
          });
  e.wrong_inputs({"This is the tensor about the centre of mass; asked for is the origin.", "inertia_tensor_origin"},
                 "about_center_of_mass", [](auto& r, auto) {
                   const auto [volume, first_moment] = volume_and_first_moment(r);
                   const Vector3d center = first_moment / or_one(volume);
                   r.colwise() -= center;
                 });
  e.wrong_output({"Your products of inertia have the wrong sign.", "inertia_tensor_products"}, "products_plus",
                 products_flipped);
  e.wrong_output({"These are the second moments of the mass; the tensor follows from them and their trace.",
                  "inertia_tensor_dyad"},
                 "second_moment", [](auto& I) -> Matrix3d { return I.trace() / 2 * Matrix3d::Identity() - I; });
  e.is_inertia_tensor("", "inertia_tensor_energy");
  e.route("divergence theorem", by_divergence_theorem);
  e.route("four points in each tetrahedron", by_points_in_tetrahedra);
  e.route("columns above the plane z = 0", by_columns_above_a_plane);
  e.survivor("k + 1 < ", "The number of corners is a multiple of three.");
  e.survivor("k + 2 <= ", "The number of corners is a multiple of three.");
  e.survivor("sum = - ", "It enters twice.");
}
