#pragma once

#include "rigid/parallel_axis.hpp"
#include "solutions/judging/judging.hpp"

/// The four masses of lecture 03.
struct FourMasses {
  Matrix3d I_origin = tensor_of_four_masses;
  double M = 10;
  Vector3d r_cm{0.5, 0.8, 1.3};
  Matrix3d I_cm = inertia_to_center_of_mass(I_origin, M, r_cm);
};

inline const Vector3d along_sweep = Vector3d(1, 2, -1).normalized();
inline constexpr const char* products_notes = "parallel_axis_products";
inline constexpr const char* theorem_notes = "parallel_axis_theorem";

inline Matrix3d unit(double size) { return size * Matrix3d::Identity(); }

/// About `place`, six equal masses with the mass, centre of mass (the origin) and inertia tensor of a given body:
/// nothing that turns can tell the two apart.
inline Matrix3d six_equivalent_masses(const Matrix3d& I_cm, double M, const Vector3d& place) {
  const PrincipalFrame spread(unit(I_cm.trace() / 2) - I_cm);
  Matrix3d I = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3d reach = sqrt(3 * max(spread.moments[i], 0.0) / M) * spread.axes.col(i);
    I += M / 6 * (of_unit_mass(reach - place) + of_unit_mass(-reach - place));
  }
  return I;
}

/// A symmetric matrix from its quadratic form, as the tensor is read off the energy.
template <class QuadraticForm>
Matrix3d from_quadratic_form(const QuadraticForm& form) {
  Matrix3d I;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector3d one = Vector3d::Unit(i), other = Vector3d::Unit(j);
      I(i, j) = (form(one + other) - form(one - other)) / 4;
    }
  }
  return I;
}
