#include "solutions/06_free_tops/shared.hpp"

void judge_linearized_rates(Lecture& lecture) {
  auto& e = lecture.exercise(&linearized_rates, {{"I", positive(kg_m2)}, {"omega3", rad_per_s}}, {"rates", rad_per_s});
  e.worked("the smallest moment about axis 3", {2, 3, 1}, 5);
  e.worked("the intermediate moment about axis 3", {3, 1, 2}, -1.5);
  e.special("a symmetric top: both rates are Ω", {1, 1, 1.8}, 2);
  e.special("a sphere", {2, 2, 2}, 1.5);
  e.special("two equal moments, one of them I3", {1, 2, 2}, 1.5);
  e.special("no spin", {2, 3, 1}, 0);
  e.random("a random body", 8, &Random::principal_moments, any::spin(0.5, 4));
  e.scale([](auto& I, auto spin) { return or_one(abs(spin) * I.maxCoeff() / min(I[0], I[1])); });
  e.sweep({"I₁ = 2, I₂ = 3 kg m², ω₃ = 1 rad/s: the signs differ where I₃ lies between", "I₃ (kg m²)", "rate (rad/s)"},
          {"Omega_1", "Omega_2"}, {1, 5}, [](auto I3) { return tuple(Vector3d(2, 3, I3), 1); });

  e.term("ω₃I₃ (1/I₁, 1/I₂)", 1, [](auto& I, auto spin) { return spin * I[2] * Vector2d(1 / I[0], 1 / I[1]); });
  e.term("ω₃ (I₂/I₁, I₁/I₂)", -1, [](auto& I, auto spin) { return spin * Vector2d(I[1] / I[0], I[0] / I[1]); });
  e.wrong_output("Ω₁ and Ω₂ are exchanged: the subscript names the moment in the denominator.", "exchanged", reversed);
  e.wrong_output("Both rates have the opposite sign: I₃ comes first in both differences.", "opposite_signs", negated);
  e.wrong("Your denominators are exchanged: Ω₁ is divided by I₁, Ω₂ by I₂.", "denominators_exchanged",
          [](auto& I, auto spin) { return spin * Vector2d((I[2] - I[1]) / I[1], (I[2] - I[0]) / I[0]); });
  e.wrong("Your numerators are exchanged: Ω₁ takes I₃ − I₂, Ω₂ takes I₃ − I₁.", "numerators_exchanged",
          [](auto& I, auto spin) { return spin * Vector2d((I[2] - I[0]) / I[0], (I[2] - I[1]) / I[1]); });
  e.wrong("These are divided by I₃; each rate is divided by the moment in front of its own equation, I₁ or I₂.",
          "divided_by_I3", [](auto& I, auto spin) { return spin * Vector2d(I[2] - I[1], I[2] - I[0]) / I[2]; });
  e.wrong("The division by I₁ and I₂ is missing.", "not_divided",
          [](auto& I, auto spin) { return spin * Vector2d(I[2] - I[1], I[2] - I[0]); });
  e.wrong_output("Ω₂ has the opposite sign: Euler's second equation holds I₁ − I₃, and the slides turn it round.",
                 "second_sign", negate(1));
  e.wrong_output("Ω₁ has the opposite sign: the slides define it by dω₁/dt = −Ω₁ω₂.", "first_sign", negate(0));
  e.wrong_output("These are the magnitudes; whether the signs agree decides about stability.", "magnitudes",
                 [](auto& rates) -> Vector2d { return rates.cwiseAbs(); });
  e.wrong_input<1>("The sense of the spin is lost: both rates change with ω₃.", "sense_of_spin_lost", without_sign);
  e.wrong_input<1>("ω₃ does not enter; both rates are proportional to the spin.", "spin_dropped", fixed(1.0));
  e.wrong_input<0>("Both your rates are the Ω of a symmetric top with I₂ = I₁; here I₂ differs.", "symmetric",
                   [](auto& I) { I[1] = I[0]; });
  e.route("ratios of moments",
          [](auto& I, auto spin) { return spin * Vector2d(I[2] / I[0] - I[1] / I[0], I[2] / I[1] - I[0] / I[1]); });
  e.route("read off Euler's equations, which are linear in ω₁ and in ω₂", [](auto& I, auto spin) {
    return Vector2d(-free_rate(I, {0, 1, spin})[0], free_rate(I, {1, 0, spin})[1]);
  });
  e.route("entry by entry",
          [](auto& I, auto spin) { return Vector2d((I[2] - I[1]) * (spin / I[0]), (I[2] - I[0]) * (spin / I[1])); });
}
