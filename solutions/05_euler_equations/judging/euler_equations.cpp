#include "solutions/05_euler_equations/shared.hpp"

void judge_euler_equations(Lecture& lecture) {
  auto& e = lecture.exercise(&euler_equations, {{"I", positive(kg_m2)}, {"omega", rad_per_s}, {"torque", newton_metre}},
                             {"omega_rate", rad_per_s2});
  e.worked("moments 1, 2, 3 under a torque", example_moments, example_omega, example_torque);
  e.special("no torque", example_moments, example_omega, zero);
  e.special("a sphere", {2, 2, 2}, example_omega, example_torque);
  e.special("rotation about a principal axis", example_moments, {0, 1.5, 0}, example_torque);
  e.special("a body at rest, no torque", example_moments, zero, zero);
  e.special("a symmetric body", {1, 1, 1.8}, example_omega, example_torque);
  e.special("a flat body", {1, 2, 3}, {2, -1, 0}, {0, 0, -1});
  e.random("a random body", 10, &Random::principal_moments, any::vector(2), any::vector(4));
  e.scale([](auto& I, auto& w, auto& tau) {
    return max((tau.norm() + I.maxCoeff() * w.squaredNorm()) / I.minCoeff(), 1e-3);
  });
  e.sweep({"Moments 1, 2, 3 kg m², τ = (0.2, 0, 0) N m: ω = (cos α, sin α, 0.5) rad/s goes round axis 3",
           "angle α (rad)", "rate of ω (rad/s²)"},
          {"dω_1/dt", "dω_2/dt", "dω_3/dt"}, {0, 6.3}, [](auto angle) {
            return tuple(example_moments, Vector3d(cos(angle), sin(angle), 0.5), Vector3d(0.2, 0, 0));
          });

  e.term("τᵢ/Iᵢ", 1, [](auto& I, auto&, auto& tau) -> Vector3d { return tau.cwiseQuotient(I); });
  e.term("ω₂L₃/I₁ (and cyclically)", -1,
         [](auto& I, auto& w, auto&) -> Vector3d { return first_products(w, L_of(I, w)).cwiseQuotient(I); });
  e.term("ω₃L₂/I₁ (and cyclically)", 1,
         [](auto& I, auto& w, auto&) -> Vector3d { return second_products(w, L_of(I, w)).cwiseQuotient(I); });
  e.wrong_terms({gyration_sign, rate_notes}, "sign_of_gyration", {1, 1, -1});
  e.wrong_terms({gyration_missing, rate_notes}, "no_gyration", {1, 0, 0});
  e.wrong_output(inertia_not_divided, "not_divided", [](auto& rate, auto& I, auto&...) { rate.array() *= I.array(); });
  e.wrong(indices_shifted, "indices_shifted", [](auto& I, auto& w, auto& tau) -> Vector3d {
    return (tau - L_of(shifted(differences(I)), products(w))).cwiseQuotient(I);
  });
  e.wrong("Each equation has the square of its own component; there belongs the product of the two others.",
          "own_squares", [](auto& I, auto& w, auto& tau) -> Vector3d {
            return (tau - L_of(differences(I), w.cwiseAbs2())).cwiseQuotient(I);
          });
  e.wrong_terms(torque_missing, "no_torque", {0, -1, 1});
  e.wrong_terms(torque_sign, "sign_of_torque", {-1, -1, 1});
  e.wrong("The torque must be divided by Iᵢ too, like the other summand of τᵢ − (ω × L)ᵢ.", "torque_not_divided",
          [](auto& I, auto& w, auto& tau) -> Vector3d { return tau - cross(w, L_of(I, w)).cwiseQuotient(I); });
  e.wrong("Only the torque is divided here: both summands of τᵢ − (ω × L)ᵢ are divided by Iᵢ.", "gyration_not_divided",
          [](auto& I, auto& w, auto& tau) -> Vector3d { return tau.cwiseQuotient(I) - cross(w, L_of(I, w)); });
  e.wrong_output("Each equation is divided by another axis's moment: that of ω₁ takes I₁, and so on.", "wrong_divisor",
                 [](auto& rate, auto& I, auto&...) { rate.array() *= I.array() / shifted(I).array(); });
  e.wrong_output("The moments multiply here where they should divide: dωᵢ/dt = (τᵢ − (ω × L)ᵢ) / Iᵢ.", "multiplied",
                 [](auto& rate, auto& I, auto&...) { rate.array() *= I.array().square(); });
  e.route("the slides' three equations", [](auto& I, auto& w, auto& tau) -> Vector3d {
    return (tau - L_of(differences(I), products(w))).cwiseQuotient(I);
  });
  e.route("with the whole tensor",
          [](auto& I, auto& w, auto& tau) { return euler_equations_general(I.asDiagonal(), w, tau); });
  e.route("with the cross matrix", [](auto& I, auto& w, auto& tau) {
    const Matrix3d tensor = I.asDiagonal();
    return tensor.inverse() * (tau - skew(w) * tensor * w);
  });
  e.route("turned into other axes and back", [](auto& I, auto& w, auto& tau) {
    const Matrix3d axes = turn({1, 2, 2}, 0.7), tensor = axes * I.asDiagonal() * axes.transpose();
    return axes.transpose() * euler_equations_general(tensor, axes * w, axes * tau);
  });
}
