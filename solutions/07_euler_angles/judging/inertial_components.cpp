#include "solutions/07_euler_angles/shared.hpp"

void judge_inertial_components(Lecture& lecture) {
  auto& e = lecture.exercise(&inertial_components, {{"V_body", metre}, {"angles", rad}}, {"V_inertial", metre});
  e.worked("the vector (1, 2, 3) at the angles of the lecture", {1, 2, 3}, example_angles);
  e.special("no turn at all", {1, 2, 3}, zero);
  e.special("the zero vector", zero, example_angles);
  e.special("θ = 0: the turns φ and ψ add up", {1, -2, 3}, {0.4, 0, 0.9});
  e.special("θ = π: upside down", {1, -2, 3}, {0.4, pi, 0.9});
  e.special("φ = ψ", {1, -2, 3}, {0.6, 1.2, 0.6});
  e.random("any vector and attitude", 8, any::vector(3), &Random::euler_angles);
  e.scale([](auto& V, auto&) { return max(V.norm(), 1e-3); });
  e.sweep({"The body axis ê₃ + ½ ê₁ while the body spins about ê₃, φ = 0.3, θ = 0.7", "ψ (rad)", "inertial component"},
          {"V_x", "V_y", "V_z"}, {0, 2 * pi},
          [](auto psi) { return tuple(Vector3d(0.5, 0, 1), Vector3d(0.3, 0.7, psi)); });

  const char* const axes[] = {"V₁ ê₁", "V₂ ê₂", "V₃ ê₃"};
  for (int i = 0; i < 3; ++i) e.term(axes[i], 1, [i](auto& V, auto& q) { return V[i] * turned_triad(q).col(i); });
  e.wrong("This is R V, from inertial to body components; the way back is the transpose of R.", "not_inverted",
          [](auto& V, auto& q) { return rotation_matrix(q) * V; });
  e.wrong_input<1>("Your turns come in the wrong order: R⁻¹ undoes ψ first, then θ, then φ.", "order_reversed",
                   exchange(0, 2));
  e.wrong("This is R_φ R_θ R_ψ V: the order is right, but each factor is still to be transposed.",
          "order_reversed_and_not_inverted", [](auto& V, auto& q) { return rotation_matrix(q.reverse()) * V; });
  e.wrong_input<1>("The turn θ goes backwards: R_θᵀ has +sin θ at the upper right.", "theta_negated", negate(1));
  e.wrong(turned_about_x, "z_x_z", [](auto& V, auto& q) { return zxz(q).transpose() * V; });
  e.wrong(turned_about_x_last, "yaw_pitch_roll", [](auto& V, auto& q) { return zyx(q).transpose() * V; });
  e.wrong_input<1>("φ does not enter: these are components after the first turn.", "phi_left_out", zeroed(0));
  e.wrong_input<1>("These are the body components, whatever the attitude.", "not_turned", fixed(zero));
  e.angles_read_as_degrees(turns_notes);
  e.route("transpose of the matrix", [](auto& V, auto& q) { return rotation_matrix(q).transpose() * V; });
  e.route("solving R x = V", [](auto& V, auto& q) { return rotation_matrix(q).inverse() * V; });
  e.route("a quaternion", [](auto& V, auto& q) { return body_to_inertial(q) * V; });
  e.route("sum over the body axes", [](auto& V, auto& q) { return turned_triad(q) * V; });
}
