#include "solutions/07_euler_angles/shared.hpp"

void judge_vertical_in_body(Lecture& lecture) {
  auto& e = lecture.exercise(&vertical_in_body, {{"theta", rad}, {"psi", rad}}, {"e3_0", none});
  e.worked("θ and ψ of the lecture", 0.7, 1.1);
  e.special("upright", 0, 1.1);
  e.special("upside down", pi, 1.1);
  e.special("lying down", pi / 2, 1.1);
  e.special("a tiny θ", 1e-8, -2);
  e.special("ψ = 0", 0.7, 0);
  e.random(
      "any attitude", 8, [](Random& random) { return random.euler_angles()[1]; }, oblique_angle);
  e.sweep<1>({"The vertical seen from a body that spins about ê₃, θ = 0.7", "ψ (rad)", "component on the body axis"},
             {"along ê_1", "along ê_2", "along ê_3"}, {0, 2 * pi});

  e.term("sin θ ê₁′", -1, [](auto theta, auto psi) { return sin(theta) * Vector3d(cos(psi), -sin(psi), 0); });
  e.term("cos θ ê₃", 1, [](auto theta, auto) { return cos(theta) * z_axis; });
  e.wrong_output(
      "The first component has the wrong sign: the body leans towards +ê₁′, so the vertical leans towards −ê₁′.",
      "first_sign", negate(0));
  e.wrong_output({"This is the vertical for z–x–z angles; on the slides the turn θ is about the y′ axis.", zxz_notes},
                 "z_x_z", quarter_turn);
  e.wrong_input<1>("sin ψ and cos ψ are exchanged: at ψ = 0 it leans to −ê₁.", "sine_and_cosine_of_psi", complement);
  e.wrong_input<0>("sin θ and cos θ are exchanged: at θ = 0 it is ê₃.", "sine_and_cosine_of_theta", complement);
  e.wrong_terms("The part across ê₃ has the wrong sign: the vertical leans the other way.", "theta_negated", {1, 1});
  e.wrong_input<1>("The turn ψ goes the wrong way: the second component is +sin θ sin ψ.", "psi_backwards", negated);
  e.wrong_input<1>("ψ does not enter: in −sin θ ê₁′ + cos θ ê₃, ê₁′ is still to be written on the body axes.",
                   "psi_left_out", fixed(0.0));
  e.wrong("This is ê₃, the vertical only at θ = 0.", "primes_read_literally", [](auto, auto) { return z_axis; });
  e.wrong_inputs("θ and ψ are exchanged; the function takes θ first.", "exchanged", first_two_exchanged);
  e.angles_read_as_degrees(turns_notes);
  e.property(Is::unit_norm, "ê₃⁰ is a unit vector.");
  e.route("R_ψ R_θ (0, 0, 1)", [](auto theta, auto psi) { return about_z(psi) * (about_y(theta) * z_axis); });
  e.route("third column of R, at any φ",
          [](auto theta, auto psi) -> Vector3d { return rotation_matrix(Vector3d(-1.7, theta, psi)).col(2); });
  e.route("a quaternion",
          [](auto theta, auto psi) { return body_to_inertial(Vector3d(0.8, theta, psi)).conjugate() * z_axis; });
}
