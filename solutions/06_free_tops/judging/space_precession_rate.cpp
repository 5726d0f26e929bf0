#include "solutions/06_free_tops/shared.hpp"

void judge_space_precession_rate(Lecture& lecture) {
  auto& e =
      lecture.exercise(&space_precession_rate, {{"I1", positive(kg_m2)}, {"I3", positive(kg_m2)}, {"omega", rad_per_s}},
                       {"rate", rad_per_s});
  e.worked("the top of the lecture", 1, 1.8, lecture_omega);
  e.worked("a plate that spins the other way", 0.5, 1, {0.8, -0.5, -3});
  e.special("a sphere", 2, 2, {0.3, -0.2, 0.5});
  e.special("no wobble", 1, 1.8, {0, 0, 2});
  e.special("no spin about the symmetry axis", 1, 1.8, {0.3, 0.4, 0});
  e.special("no rotation", 1, 1.8, zero);
  e.special("a wobble of 1e-8", 1, 1.8, {1e-8, 0, 2});
  e.random("a random top", 8, symmetric_moments, any::vector(3));
  e.scale([](auto I1, auto I3, auto& w) { return or_one(max(1.0, I3 / I1) * w.norm()); });
  e.sweep<2>({"A top of I₁ = 1, I₃ = 1.8 kg m² and ω₃ = 2 rad/s wobbles harder and harder",
              "amplitude A of the wobble (rad/s)", "rate of precession (rad/s)"},
             {"rate"}, {0, 6}, [](auto amplitude) { return Vector3d(0.6 * amplitude, 0.8 * amplitude, 2); });

  const Sentence small_wobble =
      "This is ω₃I₃/I₁, right for a small wobble only; it lacks the cosine of the angle from L to the axis as a "
      "divisor.";
  e.wrong_output("This is L/I₃; the symmetry axis runs round L with L/I₁.", "divided_by_I3",
                 [](auto& rate, auto I1, auto I3, auto&) { rate *= I1 / I3; });
  e.wrong("This is Ω, the rate seen from the body; in the inertial frame the axis runs round L with L/I₁.", "body_rate",
          [](auto I1, auto I3, auto& w) { return body_precession_rate(I1, I3, w[2]); });
  e.wrong("This is |Ω|, the rate seen from the body; in the inertial frame the axis runs round L with L/I₁.",
          "magnitude_of_body_rate", [](auto I1, auto I3, auto& w) { return abs(body_precession_rate(I1, I3, w[2])); });
  e.wrong(small_wobble, "small_wobble", [](auto I1, auto I3, auto& w) { return w[2] * I3 / I1; });
  e.wrong(small_wobble, "small_wobble_positive", [](auto I1, auto I3, auto& w) { return abs(w[2]) * I3 / I1; });
  e.wrong("This is |ω|; the axis runs round L, and L has another length than I₁|ω|.", "length_of_omega",
          [](auto, auto, auto& w) { return w.norm(); });
  e.wrong_output("This is L; the rate is L/I₁.", "not_divided", [](auto& rate, auto I1, auto&...) { rate *= I1; });
  e.wrong_inputs("I₁ and I₃ are exchanged: I₃ goes with ω₃, and I₁ divides.", "moments_exchanged", first_two_exchanged);
  e.wrong_input<2>("ω₂ does not enter; both components across the axis belong to L.", "second_component_lost",
                   zeroed(1));
  e.wrong_input<2>("ω₁ does not enter; both components across the axis belong to L.", "first_component_lost",
                   zeroed(0));
  e.wrong_output("This is L²/I₁; the square root of L² is missing.", "momentum_squared",
                 [](auto& rate, auto I1, auto&...) { rate *= rate * I1; });
  e.wrong_output(
      "Your rate changes its sign with ω₃; the axis turns about L in the right-handed sense: the rate is positive.",
      "sign_of_spin", [](auto& rate, auto, auto, auto& w) { rate = copysign(rate, w[2]); });
  e.wrong("This is the part of ω along L, which is 2T/L: it still contains the body's own spin about its axis.",
          "along_momentum", [](auto I1, auto I3, auto& w) { return w.dot(L_of(I1, I3, w).normalized()); });
  e.wrong("The components of L are added here; its length is the root of the sum of their squares.", "components_added",
          [](auto I1, auto I3, auto& w) { return L_of(I1, I3, w).sum() / I1; });
  e.wrong("This is ω₃I₃/I₁ over the cosine of the angle from the axis to ω; that from the axis to L counts.",
          "angle_to_omega", [](auto I1, auto I3, auto& w) { return w.norm() * I3 / I1; });
  e.wrong_output("This is the rate in turns per second; asked for is rad/s.", "turns_per_second", times(0.5 / pi));
  e.property(Is::nonnegative, "The precession is right-handed about L, so its rate is never negative.");
  e.route("components in turn", [](auto I1, auto I3, auto& w) {
    return sqrt(pow(I1 * w[0], 2) + pow(I1 * w[1], 2) + pow(I3 * w[2], 2)) / I1;
  });
  e.route("across and along the axis", [](auto I1, auto I3, auto& w) { return hypot(w[0], w[1], I3 / I1 * w[2]); });
  e.route("with Ω", [](auto I1, auto I3, auto& w) {
    return Vector3d(w[0], w[1], w[2] + body_precession_rate(I1, I3, w[2])).norm();
  });
  e.route("from energy and momentum", [](auto I1, auto I3, auto& w) {
    // 2T = L²/I1 − (I3 − I1) I3 ω3² / I1, solved for L.
    const double twice_energy = L_of(I1, I3, w).dot(w);
    return sqrt(I1 * twice_energy + (I3 - I1) * I3 * w[2] * w[2]) / I1;
  });
  e.survivor("omega.cwiseProduct(", "A norm depends on no sign.");
}
