#include "solutions/04_parallel_axis/shared.hpp"

void judge_inertia_from_center_of_mass(Lecture& lecture) {
  auto& e = lecture.exercise(&inertia_from_center_of_mass,
                             {{"I_cm", inertia_tensor}, {"M", positive(kg)}, {"d", metre}}, {"I", kg_m2});
  e.worked("the four masses of lecture 03, seen from (1, −1, 2)", central_tensor_of_four_masses, 10, {1, -1, 2});
  e.special("no displacement", central_tensor_of_four_masses, 10, zero);
  e.special("a displacement along z only", central_tensor_of_four_masses, 10, {0, 0, 1.5});
  e.special("a point mass", Matrix3d::Zero(), 2, {1, 2, 3});
  e.random("a random body and displacement", 8, &Random::inertia_tensor, any::uniform(1.5, 5), any::vector(2));
  e.sweep<2>({"The point moves from the centre of mass along (1, 2, −1)", "distance from the centre of mass (m)",
              "entry of I (kg m²)"},
             {"I_xx", {"I_yy", 1, 1}, {"I_xy", 0, 1}}, {0, 3}, [](auto distance) { return distance * along_sweep; });

  e.term("I_cm", 1, [](auto& I, auto, auto&) { return I; });
  e.term("M d² 1", 1, [](auto&, auto M, auto& d) { return unit(M * d.squaredNorm()); });
  e.term("M d d", -1, [](auto&, auto M, auto& d) { return M * dyad(d); });
  e.wrong_terms("M (d² 1 − d d) is subtracted; away from the centre the moments grow.", "subtracted", {1, -1, 1});
  e.wrong_terms("Only M d d is added here; the theorem adds M (d² 1 − d d).", "dyad_only", {1, 0, 1});
  e.wrong_terms("The dyad enters with the wrong sign: M (d² 1 − d d), with a minus.", "dyad_added", {1, 1, 1});
  e.wrong_terms("Every moment gains M d²; for its distance from each axis M d d is taken off.", "isotropic", {1, 1, 0});
  e.wrong({"The products of inertia do not change here; off the diagonal the shift adds −M dᵢ dⱼ.", products_notes},
          "shift_without_products", [](auto& I, auto M, auto& d) { return I + M * diagonal_part(of_unit_mass(d)); });
  e.wrong_output({"Your result has no products of inertia; the body and the shift both have them.", products_notes},
                 "diagonal_only", diagonal_part);
  e.wrong({"The products of the shift have the wrong sign: it adds −M dᵢ dⱼ.", products_notes},
          "shift_products_positive",
          [](auto& I, auto M, auto& d) { return I + M * products_flipped(of_unit_mass(d)); });
  e.wrong("The moment about x gains M d_x² here; it gains M (d_y² + d_z²), the squared distance from the axis.",
          "own_coordinate", [](auto& I, auto M, auto& d) { return I + M * products_flipped(dyad(d)); });
  e.wrong_terms("This is the tensor of a mass M at d; the body's own I_cm is missing.", "own_tensor_lost", {0, 1, -1});
  e.wrong_input<1>("The mass does not enter your shift: M (d² 1 − d d).", "mass_dropped", fixed(1.0));
  e.is_inertia_tensor();
  e.route("six equivalent masses", [](auto& I, auto M, auto& d) { return six_equivalent_masses(I, M, d); });
  e.route("minus the square of the cross matrix", [](auto& I, auto M, auto& d) { return I - M * skew(d) * skew(d); });
  e.route("read off the energy", [](auto& I, auto M, auto& d) {
    return from_quadratic_form([&](const Vector3d& w) { return w.dot(I * w) + M * cross(w, d).squaredNorm(); });
  });
  e.route("entry by entry", [](auto& I, auto M, auto& d) { return I + M * of_unit_mass_by_entries(d); });
}
