#include "solutions/03_inertia_tensor/shared.hpp"

void judge_moment_about_axis(Lecture& lecture) {
  auto& e = lecture.exercise(&moment_about_axis, {{"I", inertia_tensor}, {"axis", nonzero(none)}}, {"I_n", kg_m2});
  e.worked("the four masses about (1, 2, 2)", tensor_of_four_masses, {1, 2, 2});
  e.special("a coordinate axis", tensor_of_four_masses, Vector3d::UnitX());
  e.special("a very short axis vector", tensor_of_four_masses, {1e-5, 2e-5, -2e-5});
  e.random("a random body and axis", 8, &Random::inertia_tensor, [](auto& r) { return r.vector(r.uniform(1.5, 4)); });
  e.sweep<1>(
      {"Moment about an axis that turns from x to y and beyond", "angle of the axis from x (rad)", "moment (kg m²)"},
      {"I_n"}, {0, pi}, [](auto angle) { return 2 * in_xy_plane(angle); });

  e.term("Σ Iᵢᵢ nᵢ²", 1, [](auto& I, auto& axis) { return I.diagonal().dot(axis.normalized().cwiseAbs2()); });
  e.term("Σ Iᵢⱼ nᵢ nⱼ (i < j)", 2,
         [](auto& I, auto& axis) { return axis.dot((I - diagonal_part(I)) * axis) / (2 * axis.squaredNorm()); });
  e.wrong("The axis is not normalised: divide by |n|², so that a longer arrow gives the same moment.", "not_normalised",
          [](auto& I, auto& axis) { return axis.dot(I * axis); });
  e.wrong("This is divided by |n| once; n stands twice in n·I·n, so |n|² is to be divided by.", "normalised_once",
          [](auto& I, auto& axis) { return axis.dot(I * axis) / axis.norm(); });
  e.wrong("This is |I n|, the length of the angular momentum; the moment about the axis is its component along n.",
          "length_of_image", [](auto& I, auto& axis) { return (I * axis).norm() / axis.norm(); });
  e.wrong_terms("The products of inertia do not enter; about a tilted axis they matter.", "diagonal_only", {1, 0});
  e.wrong_terms(products_of_opposite_sign, "products_flipped", {1, -2});
  e.wrong_output("This is half of n·I·n, an energy; the moment has no factor ½.", "energy", times(0.5));
  e.wrong("This is 1/(n·I⁻¹·n), from the inverse tensor; that is another number than n·I·n.", "inverse",
          [](auto& I, auto& axis) { return axis.squaredNorm() / axis.dot(I.inverse() * axis); });
  e.property(Is::nonnegative, "A moment of inertia is never negative.");
  e.route("n·I·n / n·n", [](auto& I, auto& axis) { return axis.dot(I * axis) / axis.squaredNorm(); });
  e.route("twice the energy at unit speed", [](auto& I, auto& n) { return 2 * kinetic_energy(I, n.normalized()); });
  e.route("entry of the turned tensor", [](auto& I, auto& axis) {
    const Vector3d n = axis.normalized(), across = n.unitOrthogonal();
    return rotated_inertia(I, columns(across, cross(n, across), n).transpose())(2, 2);
  });
  e.survivor("n = - axis", "n̂ enters twice.");
}
