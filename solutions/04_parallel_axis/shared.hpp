#pragma once

#include "rigid/parallel_axis.hpp"
#include "solutions/judging/judging.hpp"

/// The centre of mass of the four masses of lecture 03, 10 kg in all, and their tensor about it.
inline const Vector3d center_of_four_masses(0.5, 0.8, 1.3);
inline const Matrix3d central_tensor_of_four_masses{{19.7, 0, 2.5}, {0, 16.6, 6.4}, {2.5, 6.4, 8.1}};

inline const Vector3d along_sweep = Vector3d(1, 2, -1).normalized();
inline constexpr const char* products_notes = "parallel_axis_products";
inline constexpr const char* theorem_notes = "parallel_axis_theorem";

inline Matrix3d unit(double size) { return size * Matrix3d::Identity(); }

/// Σ m (d² 1 − d d) for the distances from any one point.
inline Matrix3d as_points(const VectorXd& m, const Matrix3Xd& r, const Vector3d& point) {
  return tensor_of_moment(second_moment(m, r.colwise() - point));
}

/// About `place`, six equal masses with the mass, centre of mass (the origin) and inertia tensor of a given body:
/// nothing that turns can tell the two apart.
inline Matrix3d six_equivalent_masses(const Matrix3d& I_cm, double M, const Vector3d& place) {
  return as_points(VectorXd::Constant(6, M / 6), six_points(I_cm, M), place);
}

/// A body's tensor about a point off its centre of mass, its mass, and where its centre of mass is from there.
inline auto off_center(double distance) {
  return [distance](Random& random) {
    const double M = random.uniform(1.5, 5);
    const Vector3d r_cm = random.vector(distance);
    return tuple{random.inertia_tensor() + M * of_unit_mass(r_cm), M, r_cm};
  };
}
