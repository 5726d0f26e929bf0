#include "solutions/04_parallel_axis/shared.hpp"

void judge_inertia_to_center_of_mass(Lecture& lecture) {
  auto& e = lecture.exercise(&inertia_to_center_of_mass, {{"I_origin", kg_m2}, {"M", positive(kg)}, {"r_cm", metre}},
                             {"I_cm", kg_m2});
  e.domain([](auto& I, auto M, auto& r) { return is_inertia_tensor(I - M * of_unit_mass(r)); });
  e.worked("the four masses of lecture 03", tensor_of_four_masses, 10, center_of_four_masses);
  e.special("already at the centre of mass", central_tensor_of_four_masses, 10, zero);
  e.special("a cuboid of 6 kg with edges 1 m, 2 m, 3 m, from its corner", of_cuboid(6, {1, 2, 3}, 1. / 3, -1. / 4), 6,
            {0.5, 1, 1.5});
  e.special("a centre of mass on the z axis", Vector3d(2.55, 2.55, 0.3).asDiagonal(), 1, {0, 0, 1.5});
  e.random("a random body off the origin", 8, off_center(2));
  e.scale([](auto& I, auto, auto&) { return I.norm(); });  // what is taken off can be much larger than what is left
  e.sweep({"Back to the centre of cuboids (1 m, 2 m, c) whose tensors are known about a point 2 m away",
           "third edge c (m)", "entry of I_cm (kg m²)"},
          {"I_xx", {"I_zz", 2, 2}, {"I_xy", 0, 1}}, {0.5, 3}, [](auto edge) {
            const Vector3d r_cm = 2 * along_sweep;
            return tuple(inertia_from_center_of_mass(cuboid_about_center(6, 1, 2, edge), 6, r_cm), 6, r_cm);
          });

  e.term("I_origin", 1, [](auto& I, auto, auto&) { return I; });
  e.term("M r_cm² 1", -1, [](auto&, auto M, auto& r) { return unit(M * r.squaredNorm()); });
  e.term("M r_cm r_cm", 1, [](auto&, auto M, auto& r) { return M * dyad(r); });
  e.wrong_terms("M (r_CM² 1 − r_CM r_CM) is added; towards the centre the moments shrink.", "added", {1, 1, -1});
  e.wrong_terms("M (r_CM² 1 − r_CM r_CM) is subtracted twice; once is enough.", "subtracted_twice", {1, -2, 2});
  e.wrong_terms("Every moment loses M r_CM² here; M r_CM r_CM is given back to it.", "isotropic", {1, -1, 0});
  e.wrong_terms("Only M r_CM r_CM is taken off here; it is M (r_CM² 1 − r_CM r_CM).", "dyad_only", {1, 0, -1});
  e.wrong_terms("The dyad has the wrong sign: I − M (r_CM² 1 − r_CM r_CM) gives r_CM r_CM back with a plus.",
                "dyad_subtracted", {1, -1, -1});
  e.wrong({"The products of inertia do not change here; the shift adds +M xᵢ xⱼ of the centre.", products_notes},
          "shift_without_products", [](auto& I, auto M, auto& r) { return I - M * diagonal_part(of_unit_mass(r)); });
  e.wrong_output({"Your result has no products of inertia; about the centre of mass it has them too.", products_notes},
                 "diagonal_only", diagonal_part);
  e.wrong({"The products of the shift have the wrong sign: it is I_ij + M xᵢ xⱼ of the centre.", products_notes},
          "shift_products_flipped", [](auto& I, auto M, auto& r) { return I - M * products_flipped(of_unit_mass(r)); });
  e.wrong_input<1>("The mass does not enter your shift: M (r_CM² 1 − r_CM r_CM).", "mass_dropped", fixed(1.0));
  e.wrong_terms("This is the tensor about the origin unchanged.", "not_shifted", {1, 0, 0});
  e.is_inertia_tensor(theorem_notes, theorem_notes);
  e.route("by the second moment",
          [](auto& I, auto M, auto& r) { return tensor_of_moment(moment_of_tensor(I) - M * dyad(r)); });
  e.route("plus the square of the cross matrix", [](auto& I, auto M, auto& r) { return I + M * skew(r) * skew(r); });
  e.route("the slides' formula with R = −r_cm",
          [](auto& I, auto M, auto& r) { return inertia_about_shifted_origin(I, M, r, -r); });
  e.route("read off the energy", [](auto& I, auto M, auto& r) {
    return from_quadratic_form([&](const Vector3d& w) { return w.dot(I * w) - M * cross(w, r).squaredNorm(); });
  });
}
