#pragma once

#include "rigid/inertia_tensor.hpp"
#include "solutions/judging/judging.hpp"

/// The four masses of the running example: masses and positions.
inline tuple<VectorXd, Matrix3Xd> four_masses() {
  return {VectorXd{{1, 2, 3, 4}}, Matrix3Xd{{1, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 3, 1}}};
}

inline const Sentence products_of_opposite_sign{
    "The products of inertia enter with the opposite sign; the tensor already carries their minus.",
    "inertia_tensor_products"};

/// What kinetic_energy and angular_momentum are asked about.
template <class Exercise>
void add_tensors_and_omegas(Exercise& e) {
  e.worked("the four masses of the lecture", tensor_of_four_masses, example_omega);
  e.special("rotation about a principal axis", Vector3d(1, 2, 3).asDiagonal(), {0, 2, 0});
  e.special("no rotation", tensor_of_four_masses, {0, 0, 0});
  e.random("a random body", 8, &Random::inertia_tensor, any::vector(3));
}

/// Tensors with a double or triple moment, near and exact, that every eigensolver must survive.
template <class Exercise>
void add_tensors(Exercise& e) {
  e.worked("the cuboid of 6 kg with edges 1 m, 2 m, 3 m", cuboid_about_corner(6, 1, 2, 3));
  e.worked("the four masses of the lecture", tensor_of_four_masses);
  e.special("the cube about its corner (two equal moments)", cuboid_about_corner(1, 1, 1, 1));
  e.special("a sphere (three equal moments)", 2 * Matrix3d::Identity());
  e.special("already diagonal, not in order", Vector3d(3, 1, 2).asDiagonal());
  e.random("a random body", 8, &Random::inertia_tensor);
}

/// Eigenvalues and eigenvectors by Jacobi rotations, in ascending order; right-handed.
inline Matrix3d axes_by_jacobi_rotations(Matrix3d I) {
  Matrix3d axes = Matrix3d::Identity();
  for (int step = 0; step < 90; ++step) {
    const int p = step % 3 == 2 ? 1 : 0, q = step % 3 == 0 ? 1 : 2;
    const double angle = 0.5 * atan2(2 * I(p, q), I(q, q) - I(p, p));
    const Matrix3d turned = turn(Vector3d::Unit(3 - p - q), q == p + 1 ? -angle : angle);
    I = turned.transpose() * I * turned;
    axes = axes * turned;
  }
  Eigen::Vector3i order(0, 1, 2);
  std::sort(order.begin(), order.end(), [&](int i, int j) { return I(i, i) < I(j, j); });
  Matrix3d sorted;
  for (int i = 0; i < 3; ++i) sorted.col(i) = axes.col(order[i]);
  sorted.col(2) = cross(sorted.col(0), sorted.col(1));
  return sorted;
}
