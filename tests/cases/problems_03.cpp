// Worked values of the problems of lecture 03, computed elsewhere in 34 digits by two routes each.
#include "tests/cases/problems.hpp"

#include <rigid/inertia_tensor.hpp>

#include <bit>
#include <vector>

namespace problems_03 {

namespace {

Matrix3d about(const Vector3d& axis, double angle) { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }

/// On axes turned by these z–y–z angles.
Matrix3d turned(const Vector3d& moments) {
  const Matrix3d A = about(Vector3d::UnitZ(), 0.3) * about(Vector3d::UnitY(), 0.7) * about(Vector3d::UnitZ(), 1.1);
  return A * moments.asDiagonal() * A.transpose();
}

/// The twelve triangles of a cuboid between two corners, its surface seen from outside.
Matrix3Xd cuboid(const Vector3d& from, const Vector3d& to) {
  const std::vector<int> faces{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                               2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  Matrix3Xd corners(3, 36);
  for (int k = 0; k < 36; ++k) {
    const int corner = faces[static_cast<std::size_t>(k)];
    for (int i = 0; i < 3; ++i) corners(i, k) = corner >> i & 1 ? to[i] : from[i];
  }
  return corners;
}

}  // namespace

TEST_CASE("largest_angle_between_L_and_omega") {
  CHECK(agrees(largest_angle_between_L_and_omega({2.5, 1.2, 3.1}), 0.457671520097, digits));
  CHECK(agrees(largest_angle_between_L_and_omega({2, 2, 2}), 0.0, digits, 1));
  CHECK(agrees(largest_angle_between_L_and_omega({1, 1, 1.8}), 0.289751701436, digits));
  CHECK(agrees(largest_angle_between_L_and_omega({5, 0.01, 5}), 1.48141316472, digits));
}

TEST_CASE("is_inertia_tensor") {
  const auto diagonal = [](double x, double y, double z) -> Matrix3d { return Vector3d(x, y, z).asDiagonal(); };
  CHECK(is_inertia_tensor(Matrix3d{{43, -4, -4}, {-4, 36, -4}, {-4, -4, 17}}) == 1);
  CHECK(is_inertia_tensor(Matrix3d{{2, -0.8, 0}, {-0.8, 2, -0.8}, {0, -0.8, 2}}) == 0);
  CHECK(is_inertia_tensor(diagonal(10, 10, 30)) == 0);
  CHECK(is_inertia_tensor(turned({1, 2, 3})) == 1);
  CHECK(is_inertia_tensor(1e-12 * diagonal(2, 2, 5)) == 0);
  CHECK(is_inertia_tensor(Matrix3d{{3, 1, 0}, {-1, 3, 0}, {0, 0, 3}}) == 0);
  CHECK(is_inertia_tensor(turned({0, 2, 2})) == 1);
  CHECK(is_inertia_tensor(diagonal(3, -1, 3)) == 0);
  CHECK(is_inertia_tensor(diagonal(30, 10, 10)) == 0);
  CHECK(is_inertia_tensor(Matrix3d{{3, 2, 2}, {2, 3, 2}, {2, 2, 3}}) == 0);
  CHECK(is_inertia_tensor(Matrix3d::Zero()) == 1);
}

TEST_CASE("inertia_of_mesh") {
  const Vector3d A(1, 0, 0), B(0, 2, 0), C(0, 0, 3), D(1, 1, 1);
  Matrix3Xd tetrahedron(3, 12);
  tetrahedron << A, B, D, B, C, D, C, A, D, A, C, B;
  CHECK(agrees(inertia_of_mesh(tetrahedron, 2),
               Matrix3d{{3.33333333333, -0.583333333333, -0.75},
                        {-0.583333333333, 2.66666666667, -1.08333333333},
                        {-0.75, -1.08333333333, 1.66666666667}},
               digits));

  const Matrix3Xd block = cuboid({0, 0, 0}, {1, 2, 3});
  CHECK(agrees(inertia_of_mesh(block, 1), Matrix3d{{26, -3, -4.5}, {-3, 20, -9}, {-4.5, -9, 10}}, digits));
  Matrix3Xd hollow(3, 72);
  hollow << block, cuboid({0.2, 0.3, 0.5}, {0.7, 1.1, 2}).rowwise().reverse();
  CHECK(agrees(inertia_of_mesh(hollow, 1),
               Matrix3d{{24.624, -2.811, -4.1625}, {-2.811, 18.816, -8.475}, {-4.1625, -8.475, 9.54}}, digits));

  Matrix3Xd octahedron(3, 24);  // of edge 1
  for (Eigen::Index k = 0; k < 8; ++k) {
    const auto corner = [k](int axis) -> Vector3d { return (k >> axis & 1 ? -1 : 1) * Vector3d::Unit(axis); };
    const bool is_mirrored = std::popcount(static_cast<unsigned>(k)) % 2 == 1;
    octahedron.middleCols<3>(3 * k) << corner(0), corner(is_mirrored ? 2 : 1), corner(is_mirrored ? 1 : 2);
  }
  CHECK(agrees(inertia_of_mesh(octahedron / std::sqrt(2.0), 3 / std::sqrt(2.0)), 0.1 * Matrix3d::Identity(), digits));
  CHECK(agrees(inertia_of_mesh(Matrix3Xd(3, 0), 1), Matrix3d::Zero(), digits, 1));
}

TEST_CASE("balance_rotor") {
  CHECK(agrees(balance_rotor(VectorXd{{0.02, 0.03, 0.05}},
                             Matrix3Xd{{0.1, -0.04, 0.03}, {0, 0.09, -0.06}, {0.05, 0.2, -0.1}}, {-0.05, 0.25}, 0.04),
               Matrix3Xd{{-0.0720833333333, 0.0145833333333}, {0.07625, -0.06875}, {-0.05, 0.25}}, digits));
  CHECK(agrees(balance_rotor(VectorXd{{0.1, 0.1}}, Matrix3Xd{{0.1, -0.1}, {0, 0}, {0, 0.3}}, {0, 0.3}, 0.05),
               Matrix3Xd{{-0.2, 0.2}, {0, 0}, {0, 0.3}}, digits));
  CHECK(agrees(balance_rotor(VectorXd{{0.1}}, Matrix3Xd{{0.02}, {0.03}, {0.1}}, {0, 0.1}, 0.1),
               Matrix3Xd{{0, -0.02}, {0, -0.03}, {0, 0.1}}, digits));
}

TEST_CASE("inertia_rate") {
  CHECK(agrees(inertia_rate(Matrix3d{{43, -4, -4}, {-4, 36, -4}, {-4, -4, 17}}, {0.3, -0.2, 0.5}),
               Matrix3d{{5.6, 5.5, 6}, {5.5, -1.6, 2.9}, {6, 2.9, -4}}, digits));
  CHECK(agrees(inertia_rate(Vector3d(1, 2, 3).asDiagonal(), {0, 0, 2}), Matrix3d{{0, -2, 0}, {-2, 0, 0}, {0, 0, 0}},
               digits));
  CHECK(agrees(inertia_rate(Vector3d(2, 2, 3).asDiagonal(), {0, 0, 2}), Matrix3d::Zero(), digits, 1));
}

}  // namespace problems_03
