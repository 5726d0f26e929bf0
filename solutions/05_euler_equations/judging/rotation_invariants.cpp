#include "solutions/05_euler_equations/shared.hpp"

void judge_rotation_invariants(Lecture& lecture) {
  auto& e =
      lecture.exercise(&rotation_invariants, {{"I", positive(kg_m2)}, {"omega", rad_per_s}}, {"invariants", joule});
  e.result_units({joule, kg_m2_per_s * kg_m2_per_s});
  e.worked("moments 1, 2, 3", example_moments, example_omega);
  e.special("rotation about a principal axis", example_moments, {0, 0, -2});
  e.special("a sphere", {2, 2, 2}, example_omega);
  e.special("no rotation", example_moments, zero);
  e.random("a random body", 10, &Random::principal_moments, any::vector(2));
  e.scale([](auto& I, auto& w) { return I.maxCoeff() * max(w.squaredNorm(), 1e-3) * Vector2d(0.5, I.maxCoeff()); });
  e.sweep<1>({"A body with moments 1, 2, 3 kg m², ω turned from axis 1 to axis 3, |ω| = 1 rad/s",
              "angle of ω from axis 1 (rad)", "L² (kg² m⁴/s²)"},
             {{"L²", 1, 0}}, {0, pi / 2}, [](auto angle) { return Vector3d(cos(angle), 0, sin(angle)); });

  e.term("Σ I ω² in T", 0.5, [](auto& I, auto& w) { return Vector2d(I.dot(w.cwiseAbs2()), 0); });
  e.term("Σ I² ω² in L²", 1, [](auto& I, auto& w) { return Vector2d(0, L_of(I, w).squaredNorm()); });
  e.wrong_output("Your second number is Σ I ω² = 2T; L² = Σ I² ω² takes each moment squared.", "twice_the_energy",
                 [](auto& both) { both[1] = 2 * both[0]; });
  e.wrong_terms("The factor ½ of the kinetic energy is missing: T = ½ Σ I ω².", "no_half", {1, 1});
  e.wrong_output("Your second number is the length L; its square L² is asked for.", "root",
                 [](auto& both) { both[1] = sqrt(both[1]); });
  e.wrong_output("The two numbers are exchanged: T comes first, then L².", "exchanged", reversed);
  e.wrong_output("This is the square of the sum of the components of L; L² is the sum of their squares.",
                 "square_of_sum", [](auto& both, auto& I, auto& w) { both[1] = pow(I.dot(w), 2); });
  e.wrong_terms("There is no ½ in L² = Σ I² ω²; only T has one.", "half_of_square", {0.5, 0.5});
  e.wrong_output("These are 2T and the length L; asked for are T = ½ Σ I ω² and L² = Σ I² ω².",
                 "neither_square_nor_half", [](auto& both) { both = Vector2d(2 * both[0], sqrt(both[1])); });
  e.wrong_output("Your T is L²/2, with the moments squared; T = ½ Σ I ω² takes each moment once.",
                 "energy_from_momentum_squared", [](auto& both) { both[0] = both[1] / 2; });
  e.wrong_output("Your T is ½ Σ ω², without the moments; T = ½ Σ I ω².", "moments_dropped_once",
                 [](auto& both, auto&, auto& w) { both[0] = w.squaredNorm() / 2; });
  e.property(Is::nonnegative, "Neither a kinetic energy nor a square is negative.");
  e.route("with the whole tensor", [](auto& I, auto& w) {
    const Matrix3d tensor = I.asDiagonal();
    return Vector2d(0.5 * w.dot(tensor * w), w.dot(tensor * tensor * w));
  });
  e.route("component by component", [](auto& I, auto& w) {
    Vector2d sums = Vector2d::Zero();
    for (int i = 2; i >= 0; --i) sums += Vector2d(I[i] * pow(w[i], 2) / 2, pow(I[i] * w[i], 2));
    return sums;
  });
  e.route("from L alone", [](auto& I, auto& w) {
    const Vector3d L = L_of(I, w);
    return Vector2d(L.cwiseQuotient(I).dot(L) / 2, L.dot(L));
  });
}
