#include "solutions/03_inertia_tensor/shared.hpp"

void judge_kinetic_energy(Lecture& lecture) {
  auto& e = lecture.exercise(&kinetic_energy, {{"I", inertia_tensor}, {"omega", rad_per_s}}, {"T", joule});
  add_tensors_and_omegas(e);
  e.scale([](auto& I, auto& w) { return I.norm() * max(w.squaredNorm(), 1e-3) / 2; });
  e.sweep<1>(
      {"Energy over the direction of ω, |ω| = 1 rad/s", "angle of ω from the x axis in the xy plane (rad)", "T (J)"},
      {"T"}, {0, 2 * pi}, in_xy_plane);

  e.term("Σ Iᵢᵢ ωᵢ²", 0.5, [](auto& I, auto& w) { return I.diagonal().dot(w.cwiseAbs2()); });
  e.term("Σ Iᵢⱼ ωᵢ ωⱼ (i < j)", 1, [](auto& I, auto& w) { return w.dot((I - diagonal_part(I)) * w) / 2; });
  e.wrong_output("The factor ½ is missing: T = ½ ω·I·ω.", "no_half", times(2));
  e.wrong_terms("The products of inertia do not enter; ω·I·ω has nine terms, not three.", "diagonal_only", {0.5, 0});
  e.wrong(
      {"A third of the trace stands for the inertia; the moment depends on the direction of ω.", "inertia_tensor_axis"},
      "mean_moment", [](auto& I, auto& w) { return 0.5 * I.trace() / 3 * w.squaredNorm(); });
  e.wrong("This is half the product of the lengths of L and ω; the energy is their dot product, T = ½ L·ω.",
          "product_of_norms", [](auto& I, auto& w) { return 0.5 * (I * w).norm() * w.norm(); });
  e.wrong("This is L²/2I with the moment about the axis of ω, as if L were along ω; only its part along ω counts.",
          "momentum_along_omega", [](auto& I, auto& w) {
            const Vector3d L = I * w;
            return w.dot(L) > 0 ? L.squaredNorm() * w.squaredNorm() / (2 * w.dot(L)) : 0.0;
          });
  e.wrong_terms(products_of_opposite_sign, "products_flipped", {0.5, -1});
  e.wrong_output("Your energy grows in proportion to |ω|; it must be quadratic in ω.", "omega_not_squared",
                 [](auto& T, auto&, auto& w) { T /= or_one(w.norm()); });
  e.wrong_terms("Each product of inertia enters once; ω·I·ω has I_xy and I_yx.", "upper_triangle_once", {0.5, 0.5});
  e.property(Is::nonnegative, "A kinetic energy is never negative.");
  e.route("half of L·ω", [](auto& I, auto& w) { return angular_momentum(I, w).dot(w) / 2; });
  e.route("entry by entry", [](auto& I, auto& w) { return dyad(w).cwiseProduct(I).sum() / 2; });
  e.route("on principal axes", [](auto& I, auto& w) {
    const PrincipalFrame frame(I);
    return 0.5 * frame.moments.dot((frame.axes.transpose() * w).cwiseAbs2());
  });
}
