#include "solutions/04_parallel_axis/shared.hpp"

void judge_inertia_about_shifted_origin(Lecture& lecture) {
  auto& e = lecture.exercise(&inertia_about_shifted_origin,
                             {{"I_origin", kg_m2}, {"M", positive(kg)}, {"r_cm", metre}, {"R", metre}}, {"I", kg_m2});
  e.domain([](auto& I, auto M, auto& r, auto&) { return is_inertia_tensor(I - M * of_unit_mass(r)); });
  const Matrix3d I0 = tensor_of_four_masses;
  const Vector3d r0 = center_of_four_masses;
  e.worked("the four masses of lecture 03 with R = (0.5, −1, 2)", I0, 10, r0, {0.5, -1, 2});
  e.special("to the centre of mass, R = −r_cm", I0, 10, r0, -r0);
  e.special("from the centre of mass, r_cm = 0", central_tensor_of_four_masses, 10, zero, {1, -1, 2});
  e.special("no shift", I0, 10, r0, zero);
  e.special("to the mirror point, R = −2 r_cm", I0, 10, r0, -2 * r0);
  e.random("a random body and shift", 8, off_center(1.5), any::vector(2));
  // The terms cancel where the new origin lies near the centre of mass, so their size is the scale.
  e.scale([](auto& I, auto M, auto& r, auto& R) { return I.norm() + M * R.norm() * (R.norm() + 2 * r.norm()); });
  e.sweep<3>({"The origin moves by s along (1, 2, −1)", "s, with R = −s (1, 2, −1)/√6 (m)", "entry of I (kg m²)"},
             {"I_xx", {"I_yy", 1, 1}, {"I_xy", 0, 1}}, {-2, 3}, [](auto s) { return -s * along_sweep; });

  e.term("I_origin", 1, [](auto& I, auto, auto&, auto&) { return I; });
  e.term("M R² 1", 1, [](auto&, auto M, auto&, auto& R) { return unit(M * R.squaredNorm()); });
  e.term("M R R", -1, [](auto&, auto M, auto&, auto& R) { return M * dyad(R); });
  e.term("M r_cm·R 1", 2, [](auto&, auto M, auto& r, auto& R) { return unit(M * r.dot(R)); });
  e.term("M r_cm R", -1, [](auto&, auto M, auto& r, auto& R) { return M * r * R.transpose(); });
  e.term("M R r_cm", -1, [](auto&, auto M, auto& r, auto& R) { return M * R * r.transpose(); });
  const Sentence one_dyad = "Only one of the two dyads r_CM R and R r_CM enters, so your tensor is not symmetric.";
  e.wrong_terms("The terms with r_CM are missing: this is right only if the old origin is the centre of mass.",
                "no_mixed_terms", {1, 1, -1, 0, 0, 0});
  e.wrong_input<3>({"The terms with r_CM have the wrong sign: positions become r + R.", "parallel_axis_direction"},
                   "direction_of_R", negated);
  e.wrong_terms("r_CM·R enters once on your diagonal; it comes from 2 r·R in |r + R|², so it enters twice.",
                "one_scalar_product", {1, 1, -1, 1, -1, -1});
  e.wrong_terms(one_dyad, "one_dyad_r_R", {1, 1, -1, 2, -1, 0});
  e.wrong_terms(one_dyad, "one_dyad_R_r", {1, 1, -1, 2, 0, -1});
  e.wrong_terms("The term 2 r_CM·R on the diagonal is missing.", "no_scalar_product", {1, 1, -1, 0, -1, -1});
  e.wrong_terms("The dyads r_CM R and R r_CM are missing, and their products.", "no_dyads", {1, 1, -1, 2, 0, 0});
  e.wrong_terms({"M (R² 1 − R R) is subtracted, right only for R = −r_CM.", "parallel_axis_back"}, "special_case",
                {1, -1, 1, 0, 0, 0});
  e.wrong_inputs("This is the tensor about the centre of mass; asked for is the point at −R.", "center_of_mass",
                 [](auto&, auto, auto& r, auto& R) { R = -r; });
  e.wrong("The step from the centre of mass is R here; its distance from the new origin is r_CM + R.",
          "displacement_from_center",
          [](auto& I, auto M, auto& r, auto& R) { return I + M * (of_unit_mass(R) - of_unit_mass(r)); });
  e.wrong("M ((r_CM + R)² 1 − …) is added to I_origin here; it belongs to the tensor about the centre of mass.",
          "origin_taken_for_center", [](auto& I, auto M, auto& r, auto& R) { return I + M * of_unit_mass(r + R); });
  e.wrong("The mass does not enter the terms with r_CM.", "mixed_without_mass",
          [](auto& I, auto M, auto& r, auto& R) { return inertia_about_shifted_origin(I, M, r / M, R); });
  e.wrong_input<1>("The mass does not enter your shift.", "mass_dropped", fixed(1.0));
  e.wrong_output({"Your result has no products of inertia; only special shifts remove them.", products_notes},
                 "diagonal_only", diagonal_part);
  e.wrong_terms("This is the tensor about the old origin unchanged.", "not_shifted", {1, 0, 0, 0, 0, 0});
  e.is_inertia_tensor(theorem_notes, theorem_notes);
  e.route("over the centre of mass", [](auto& I, auto M, auto& r, auto& R) {
    return inertia_from_center_of_mass(inertia_to_center_of_mass(I, M, r), M, r + R);
  });
  e.route("six equivalent masses", [](auto& I, auto M, auto& r, auto& R) {
    return six_equivalent_masses(inertia_to_center_of_mass(I, M, r), M, r + R);
  });
  e.route("squares of cross matrices",
          [](auto& I, auto M, auto& r, auto& R) { return I + M * (skew(r) * skew(r) - skew(r + R) * skew(r + R)); });
}
