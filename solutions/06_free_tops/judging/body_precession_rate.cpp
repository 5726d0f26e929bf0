#include "solutions/06_free_tops/shared.hpp"

void judge_body_precession_rate(Lecture& lecture) {
  auto& e =
      lecture.exercise(&body_precession_rate, {{"I1", positive(kg_m2)}, {"I3", positive(kg_m2)}, {"omega3", rad_per_s}},
                       {"Omega", rad_per_s});
  e.worked("the top of the lecture", 1, 1.8, 2);
  e.worked("a long top, whose Ω is negative", 2, 0.5, 3);
  e.worked("a long top that spins the other way", 2, 0.5, -3);
  e.special("a sphere", 2, 2, 1.5);
  e.special("a flat plate, I3 = 2 I1", 0.5, 1, 3);
  e.special("nearly a sphere", 1, 1 + 1e-6, 2);
  e.special("no spin", 1, 1.8, 0);
  e.random("a random top", 8, symmetric_moments, any::spin(0.5, 4));
  e.scale([](auto, auto, auto spin) { return or_one(abs(spin)); });
  e.sweep(
      {"A top of I₁ = 1 kg m² and ω₃ = 1 rad/s: from the needle through the sphere to the plate", "I₃/I₁", "Ω (rad/s)"},
      {"Omega"}, {0.02, 2}, [](auto ratio) { return tuple(1, ratio, 1); });

  e.term("ω₃ I₃/I₁", 1, [](auto I1, auto I3, auto spin) { return spin * I3 / I1; });
  e.term("ω₃", -1, [](auto, auto, auto spin) { return spin; });
  e.wrong_terms("Your rate has the opposite sign: on the slides Ω = ω₃ (I₃ − I₁)/I₁.", "opposite_sign", {-1, 1});
  e.wrong_output("This is divided by I₃; the equation for ω₁ has I₁ in front of its rate, so Ω is divided by I₁.",
                 "divided_by_I3", [](auto& rate, auto I1, auto I3, auto) { rate *= I1 / I3; });
  e.wrong_inputs("I₁ and I₃ are exchanged in your formula; I₃ belongs to the symmetry axis.", "moments_exchanged",
                 first_two_exchanged);
  e.wrong("Your fraction stands on its head: (I₃ − I₁) belongs above, I₁ below.", "inverted",
          [](auto I1, auto I3, auto spin) { return over(spin * I1, I3 - I1); });
  e.wrong_terms({"This is ω₃I₃/I₁, the inertial rate of a small wobble; from the body it is less by ω₃.", space_notes},
                "space_rate", {1, 0});
  e.wrong_terms("The moments are added; Euler's equation has their difference, I₃ − I₁.", "sum_of_moments", {1, 1});
  e.wrong_output("This is the magnitude of Ω; its sign says which way ω runs round.", "magnitude", without_sign);
  e.wrong_input<2>("The sense of the spin is lost: Ω changes its sign with ω₃.", "sense_of_spin_lost", without_sign);
  e.wrong_input<2>("ω₃ does not enter; Ω is proportional to the spin.", "spin_dropped", fixed(1.0));
  e.wrong_output("This is Ω/2π, in turns per second; asked for is rad/s.", "turns_per_second", times(0.5 / pi));
  e.wrong_output("This is the period 2π/Ω, not the rate Ω.", "period", [](auto& rate) { rate = over(2 * pi, rate); });
  e.route("one less than the ratio", [](auto I1, auto I3, auto spin) { return (I3 / I1 - 1) * spin; });
  e.route("difference of two rates", [](auto I1, auto I3, auto spin) { return I3 * spin / I1 - spin; });
  e.route("read off Euler's equations",
          [](auto I1, auto I3, auto spin) { return free_rate(Vector3d(I1, I1, I3), Vector3d(1, 0, spin))[1]; });
}
