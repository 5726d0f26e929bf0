#include "solutions/03_inertia_tensor/shared.hpp"

void judge_angular_momentum(Lecture& lecture) {
  auto& e = lecture.exercise(&angular_momentum, {{"I", inertia_tensor}, {"omega", rad_per_s}}, {"L", kg_m2_per_s});
  add_tensors_and_omegas(e);
  e.scale([](auto& I, auto& w) { return I.norm() * max(w.norm(), 1e-3); });
  e.sweep<1>({"Angular momentum while ω turns in the xy plane, |ω| = 1 rad/s", "angle of ω from the x axis (rad)",
              "component of L (kg m²/s)"},
             {"L_x", "L_y", "L_z"}, {0, 2 * pi}, in_xy_plane);

  e.term("Iᵢᵢ ωᵢ (diagonal)", 1, [](auto& I, auto& w) { return diagonal_part(I) * w; });
  e.term("Σ Iᵢⱼ ωⱼ (j ≠ i)", 1, [](auto& I, auto& w) { return (I - diagonal_part(I)) * w; });
  e.wrong("Your L points along ω; that holds only when ω lies along a principal axis.", "parallel_to_omega",
          [](auto& I, auto& w) { return w.dot(I * w) / or_one(w.squaredNorm()) * w; });
  e.wrong_terms("The products of inertia do not enter; each L_i takes a whole row of I.", "diagonal_only", {1, 0});
  e.wrong("A third of the trace stands for the inertia here, so your L is parallel to ω.", "mean_moment",
          [](auto& I, auto& w) { return I.trace() / 3 * w; });
  e.wrong_terms(products_of_opposite_sign, "products_flipped", {1, -1});
  e.wrong("This is ω × L, the torque that would hold ω constant; asked for is L itself.", "rate_of_change",
          [](auto& I, auto& w) { return cross(w, I * w); });
  e.wrong("This is I⁻¹ω, the solution of I x = ω; the angular momentum is the product I ω.", "inverse_tensor",
          [](auto& I, auto& w) { return I.inverse() * w; });
  e.route("row by row", [](auto& I, auto& w) { return Vector3d(I.row(0).dot(w), I.row(1).dot(w), I.row(2).dot(w)); });
  e.route("sum of columns", [](auto& I, auto& w) { return w[2] * I.col(2) + w[1] * I.col(1) + w[0] * I.col(0); });
  e.route("gradient of the energy", [](auto& I, auto& w) {
    return 2 * from_quadratic_form([&](const Vector3d& omega) { return kinetic_energy(I, omega); }) * w;
  });
}
