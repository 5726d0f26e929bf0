#include "solutions/05_euler_equations/shared.hpp"

void judge_torque_to_hold_rotation(Lecture& lecture) {
  auto& e = lecture.exercise(&torque_to_hold_rotation, {{"I", regular_tensor}, {"omega", rad_per_s}},
                             {"torque", newton_metre});
  e.worked("the four masses of lecture 03", tensor_of_four_masses, example_omega);
  e.special("rotation about a principal axis", tensor_of_example, {0, 2, 0});
  e.special("a sphere", tensor_of_sphere, example_omega);
  e.special("principal axes, oblique ω", tensor_of_example, example_omega);
  e.special("no rotation", tensor_of_four_masses, zero);
  e.random("a random body", 10, &Random::inertia_tensor, any::vector(3));
  e.scale([](auto& I, auto& w) { return I.norm() * max(w.squaredNorm(), 1e-3); });
  e.sweep<1>({"The torque on the four masses while ω points round the xy plane, |ω| = 1 rad/s",
              "angle of ω from the x axis (rad)", "component of the torque (N m)"},
             {"τ_x", "τ_y", "τ_z"}, {0, 6.3}, in_xy_plane);

  e.term("(ω_y L_z, ω_z L_x, ω_x L_y)", 1, [](auto& I, auto& w) { return first_products(w, I * w); });
  e.term("(ω_z L_y, ω_x L_z, ω_y L_x)", -1, [](auto& I, auto& w) { return second_products(w, I * w); });
  e.wrong_terms("Zero torque keeps L constant in space; here L turns with the body.", "zero", {0, 0});
  e.wrong_terms("The sign is wrong: this is the body's torque on its bearings; on it acts ω × L.", "sign", {-1, 1});
  e.wrong("This is L = Iω; the torque is its rate, ω × L.", "momentum", [](auto& I, auto& w) { return I * w; });
  e.wrong_input<0>(products_missing, "diagonal_only", diagonal_part);
  e.wrong_input<0>(products_sign, "products_flipped", products_flipped);
  e.wrong("This is |ω| L; ω × L leaves only the part of L across ω, turned by a right angle.", "lengths_multiplied",
          [](auto& I, auto& w) { return w.norm() * (I * w); });
  e.wrong("This is the angular acceleration of the body left alone; asked for is the torque that prevents it.",
          "acceleration", [](auto& I, auto& w) { return -I.inverse() * cross(w, I * w); });
  e.perpendicular_to(1, "The torque stands at right angles to ω, for the energy stays the same: it does no work.");
  e.route("Euler's equations read backwards",
          [](auto& I, auto& w) { return I * -euler_equations_general(I, w, zero); });
  e.route("with the cross matrix", [](auto& I, auto& w) { return skew(w) * I * w; });
  e.route("on principal axes and back", [](auto& I, auto& w) {
    const auto [moments, axes] = PrincipalFrame(I);
    return axes * L_of(differences(moments), products(axes.transpose() * w));
  });
  e.route("the turning of L in a short time", [](auto& I, auto& w) {
    return w.norm() * derivative_at_0([&](double angle) { return turn(w, angle) * (I * w); }, 0.005);
  });
}
