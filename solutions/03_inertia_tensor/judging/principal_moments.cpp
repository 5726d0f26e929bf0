#include "solutions/03_inertia_tensor/shared.hpp"

/// Eigenvalues from the characteristic polynomial by its trigonometric solution: a route without an eigensolver.
static Vector3d moments_by_cubic_formula(const Matrix3d& I) {
  const double mean = I.trace() / 3;
  const Matrix3d deviator = I - mean * Matrix3d::Identity();
  const double p = sqrt(deviator.squaredNorm() / 6);
  if (p == 0) return Vector3d::Constant(mean);
  const double angle = acos(clamp((deviator / p).determinant() / 2, -1.0, 1.0)) / 3, third = 2 * pi / 3;
  return Vector3d::Constant(mean) + 2 * p * Vector3d(cos(angle + third), cos(angle - third), cos(angle));
}

void judge_principal_moments(Lecture& lecture) {
  auto& e = lecture.exercise(&principal_moments, {{"I", inertia_tensor}}, {"moments", kg_m2});
  add_tensors(e);
  e.special("two moments nearly equal", Vector3d(1, 1 + 1e-7, 1.5).asDiagonal());
  e.tolerance_of_last_case(
      1e-7, "Where two moments nearly agree, the closed formula for the roots of a cubic loses half of its digits.");
  e.special("the cube about its corner, by a closed formula too", cuboid_about_corner(2, 1.5, 1.5, 1.5));
  e.tolerance_of_last_case(1e-7);
  e.sweep(
      {"Principal moments of a 1 kg cuboid (a, 1 m, 2 m) about its corner", "edge a (m)", "principal moment (kg m²)"},
      {"I_1", "I_2", "I_3"}, {0.1, 3}, [](auto a) { return cuboid_about_corner(1, a, 1, 2); });

  e.wrong("This is the diagonal of I, sorted; it holds the principal moments only if the products vanish.",
          "diagonal_sorted", [](auto& I) { return principal_moments(diagonal_part(I)); });
  e.wrong("This is the diagonal of I; it holds the principal moments only if the products vanish.", "diagonal",
          [](auto& I) -> Vector3d { return I.diagonal(); });
  e.wrong_output("The moments come in descending order; ascending is asked for.", "descending", reversed);
  e.wrong_input<0>(products_of_opposite_sign, "products_flipped", products_flipped);
  e.wrong_output("These are the squares of the principal moments.", "squared",
                 [](auto& moments) -> Vector3d { return moments.cwiseAbs2(); });
  e.wrong_input<0>("Your products of inertia count half; the solver needs the whole symmetric tensor.",
                   "lower_triangle_twice", [](auto& I) { return 0.5 * (I + diagonal_part(I)); });
  e.property(Is::ascending, "The moments are asked for in ascending order.");
  e.property(Is::nonnegative, "A principal moment is never negative.");
  e.route("roots of the characteristic polynomial", moments_by_cubic_formula);
  e.route("Jacobi rotations", [](auto& I) -> Vector3d {
    const Matrix3d axes = axes_by_jacobi_rotations(I);
    return (axes.transpose() * I * axes).diagonal();
  });
  e.route("singular values", [](auto& I) -> Vector3d { return I.jacobiSvd().singularValues().reverse(); });
}
