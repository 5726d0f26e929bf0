#include "solutions/06_free_tops/shared.hpp"

/// (I₂ − I₁)(I₃ − I₂)
static double product(const Vector3d& I) { return (I[1] - I[0]) * (I[2] - I[1]); }

void judge_growth_rate(Lecture& lecture) {
  auto& e =
      lecture.exercise(&growth_rate, {{"I_ascending", ascending_moments}, {"omega2", rad_per_s}}, {"sigma", per_s});
  e.worked("moments 1, 2, 3", {1, 2, 3}, 1.5);
  e.worked("moments 2, 3, 4 and the other sense", {2, 3, 4}, -2.5);
  e.special("I1 = I2", {2, 2, 3}, 1.5);
  e.tolerance_of_last_case(1e-6, "At equal moments the root of a rounding error is left of some sound ways through.");
  e.special("I2 = I3", {1, 2, 2}, 1.5);
  e.tolerance_of_last_case(1e-6);
  e.special("a sphere", {2, 2, 2}, 1.5);
  e.tolerance_of_last_case(1e-6);
  e.special("no spin", {1, 2, 3}, 0);
  e.special("moments that differ by a millionth", {1, 1 + 1e-6, 1 + 2e-6}, 1.5);
  e.random("a random body", 10, &Random::ascending_moments, any::spin(0.5, 4));
  e.scale([](auto&, auto spin) { return or_one(abs(spin)); });
  e.sweep({"I₁ = 2, I₃ = 3 kg m², ω₂ = 1 rad/s: fastest where I₂ lies half-way", "I₂ (kg m²)", "σ (1/s)"}, {"sigma"},
          {2, 3}, [](auto I2) { return tuple(Vector3d(2, I2, 3), 1); });

  e.wrong_output("This is σ²: the square root is missing.", "squared", [](auto& rate) { rate *= rate; });
  e.wrong("The square root is missing over the moments of inertia.", "no_root_of_moments",
          [](auto& I, auto spin) { return abs(spin) * product(I) / (I[0] * I[2]); });
  e.wrong_input<1>("ω₂ does not enter; σ is proportional to the spin.", "spin_dropped", fixed(1.0));
  const Sentence own_moment = "I₂ stands in your denominator; the moments of the two other axes belong there, I₁I₃.";
  e.wrong_output(own_moment, "own_moment_squared", [](auto& rate, auto& I, auto) { rate *= sqrt(I[0] * I[2]) / I[1]; });
  e.wrong_output(own_moment, "own_moment_for_third", [](auto& rate, auto& I, auto) { rate *= sqrt(I[2] / I[1]); });
  e.wrong_output(own_moment, "own_moment_for_first", [](auto& rate, auto& I, auto) { rate *= sqrt(I[0] / I[1]); });
  e.wrong("This is half the sum of the factors in the two rates; the root of their product is the rate of growth.",
          "mean_of_factors",
          [](auto& I, auto spin) { return abs(spin) * ((I[2] - I[1]) / I[0] + (I[1] - I[0]) / I[2]) / 2; });
  e.wrong_output("Your rate is negative when ω₂ is; a disturbance grows in either sense of the spin.",
                 "negative_for_negative_spin", [](auto& rate, auto&, auto spin) { rate = copysign(rate, spin); });
  e.wrong_output("This is −σ, of the dying part of a disturbance; the rest grows with +σ.", "decaying", negated);
  e.wrong(
      {"This is the frequency of a wobble about axis 3, which is stable; the spin is about axis 2.", stability_notes},
      "about_the_largest", [](auto& I, auto spin) { return wobble_about(I, spin, 2); });
  e.wrong(
      {"This is the frequency of a wobble about axis 1, which is stable; the spin is about axis 2.", stability_notes},
      "about_the_smallest", [](auto& I, auto spin) { return wobble_about(I, spin, 0); });
  e.wrong_output("This is the time 1/σ in which a disturbance grows e-fold; asked for is the rate.", "time",
                 [](auto& rate) { rate = over(1, rate); });
  e.wrong_output("This is 2π/σ; a growing disturbance has no period, and asked for is its rate.", "period",
                 [](auto& rate) { rate = over(2 * pi, rate); });
  e.wrong_output("This is σ/2π; σ is a rate of growth, not a frequency in turns.", "over_two_pi", times(0.5 / pi));
  e.wrong("I₃ − I₁ stands here; it is the differences to the intermediate moment that count.", "outer_difference",
          [](auto& I, auto spin) { return abs(spin) * (I[2] - I[0]) / sqrt(I[0] * I[2]); });
  e.wrong_output("1/√(I₁I₃) is missing.", "not_divided", [](auto& rate, auto& I, auto) { rate *= sqrt(I[0] * I[2]); });
  e.property(Is::nonnegative, "The rate of growth is never negative.");
  e.route("root by root",
          [](auto& I, auto spin) { return sqrt((I[1] - I[0]) / I[2]) * sqrt((I[2] - I[1]) / I[0]) * abs(spin); });
  e.route("an eigenvalue of the linearized equations", [](auto& I, auto spin) {
    Matrix3d system = Matrix3d::Zero();
    system(0, 2) = (I[1] - I[2]) / I[0] * spin;
    system(2, 0) = (I[0] - I[1]) / I[2] * spin;
    return sqrt((system * system).trace() / 2);
  });
  e.route("from the two rates", [](auto& I, auto spin) { return wobble_about(I, spin, 1); });
  e.survivor("Vector3d& I = ", "Only ratios of moments enter.");
}
